#include "core/sim/mesh.h"

#include <cmath>
#include <numbers>

namespace gripscan::sim {
namespace {

/// Adds the triangle unless it has no area.
void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Eigen::Vector3d& p = mesh.vertices[a];
    const double area = (mesh.vertices[b] - p).cross(mesh.vertices[c] - p).norm();
    if (area > 1e-14) mesh.triangles.push_back({a, b, c});
}

/// For convex bodies around the origin: turns the triangle so that it looks outwards.
void add_outward(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Eigen::Vector3d& p = mesh.vertices[a];
    const Eigen::Vector3d n = (mesh.vertices[b] - p).cross(mesh.vertices[c] - p);
    const bool outward = n.dot(p + mesh.vertices[b] + mesh.vertices[c]) > 0.0;
    add_triangle(mesh, a, outward ? b : c, outward ? c : b);
}

void add_outward_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                      std::uint32_t d) {
    add_outward(mesh, a, b, c);
    add_outward(mesh, a, c, d);
}

std::vector<Eigen::Vector2d> arc(double radius, double z, double from_rad, double to_rad) {
    constexpr int kSteps = 24;
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i <= kSteps; ++i) {
        const double a = from_rad + (to_rad - from_rad) * i / kSteps;
        points.emplace_back(std::max(0.0, radius * std::cos(a)), z + radius * std::sin(a));
    }
    return points;
}

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

bool is_ear(const std::vector<Eigen::Vector2d>& p, const std::vector<std::uint32_t>& ring,
            std::size_t i) {
    const std::size_t n = ring.size();
    const std::uint32_t ia = ring[(i + n - 1) % n];
    const std::uint32_t ib = ring[i];
    const std::uint32_t ic = ring[(i + 1) % n];
    if (cross2(p[ib] - p[ia], p[ic] - p[ib]) <= 0.0) return false;
    for (const std::uint32_t other : ring) {
        if (other == ia || other == ib || other == ic) continue;
        const Eigen::Vector2d& q = p[other];
        if (cross2(p[ib] - p[ia], q - p[ia]) >= 0.0 && cross2(p[ic] - p[ib], q - p[ib]) >= 0.0 &&
            cross2(p[ia] - p[ic], q - p[ic]) >= 0.0) {
            return false;
        }
    }
    return true;
}

/// Ear clipping (Meisters 1975): triangles of a simple counter-clockwise polygon.
std::vector<std::array<std::uint32_t, 3>> triangulated(const std::vector<Eigen::Vector2d>& p) {
    std::vector<std::uint32_t> ring(p.size());
    for (std::uint32_t i = 0; i < ring.size(); ++i) ring[i] = i;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (ring.size() > 3) {
        std::size_t ear = 0;
        while (ear < ring.size() && !is_ear(p, ring, ear)) ++ear;
        if (ear == ring.size()) break;
        const std::size_t n = ring.size();
        triangles.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({ring[0], ring[1], ring[2]});
    return triangles;
}

}  // namespace

void append(Mesh& mesh, const Mesh& more, const Pose& T_mesh_more) {
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& v : more.vertices) mesh.vertices.push_back(T_mesh_more * v);
    for (const auto& [a, b, c] : more.triangles) {
        mesh.triangles.push_back({a + offset, b + offset, c + offset});
    }
}

Mesh moved(const Mesh& mesh, const Pose& T_target_mesh) {
    Mesh result;
    append(result, mesh, T_target_mesh);
    return result;
}

Pose frame_at(const Eigen::Vector3d& origin, const Eigen::Vector3d& z_direction) {
    Pose T = Pose::Identity();
    T.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z_direction)
                     .toRotationMatrix();
    T.translation() = origin;
    return T;
}

Mesh chamfered_box(const Eigen::Vector3d& size_m, double chamfer_m) {
    // Each corner of the box becomes a triangle; vertex 3 · corner + axis lies on the face of
    // that axis.
    Mesh mesh;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            Eigen::Vector3d p;
            for (int i = 0; i < 3; ++i) {
                const double half = size_m[i] / 2.0 - (i == axis ? 0.0 : chamfer_m);
                p[i] = ((corner >> i) & 1U) != 0 ? half : -half;
            }
            mesh.vertices.push_back(p);
        }
        add_outward(mesh, 3 * corner, 3 * corner + 1, 3 * corner + 2);
    }
    for (std::uint32_t e = 0; e < 3; ++e) {
        const std::uint32_t a = (e + 1) % 3;
        const std::uint32_t b = (e + 2) % 3;
        const std::uint32_t step_e = 3U << e;
        const std::uint32_t step_a = 3U << a;
        const std::uint32_t step_b = 3U << b;
        for (std::uint32_t corner = 0; corner < 8; ++corner) {
            const std::uint32_t v = 3 * corner;
            if (((corner >> e) & 1U) == 0) {  // the edge along e, between the faces a and b
                add_outward_quad(mesh, v + a, v + b, v + step_e + b, v + step_e + a);
            }
            if (((corner >> a) & 1U) == 0 && ((corner >> b) & 1U) == 0) {  // the face of axis e
                add_outward_quad(mesh, v + e, v + step_a + e, v + step_a + step_b + e,
                                 v + step_b + e);
            }
        }
    }
    return mesh;
}

Mesh lathe(const std::vector<Eigen::Vector2d>& profile_m, int segments) {
    std::vector<Eigen::Vector2d> profile = profile_m;
    if (profile.front().x() > 0.0) profile.insert(profile.begin(), {0.0, profile.front().y()});
    if (profile.back().x() > 0.0) profile.emplace_back(0.0, profile.back().y());
    Mesh mesh;
    const auto n = static_cast<std::uint32_t>(segments);
    for (const Eigen::Vector2d& p : profile) {
        for (std::uint32_t s = 0; s < n; ++s) {
            const double angle = 2.0 * std::numbers::pi * s / n;
            mesh.vertices.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
        }
    }
    for (std::uint32_t row = 0; row + 1 < profile.size(); ++row) {
        for (std::uint32_t s = 0; s < n; ++s) {
            const std::uint32_t a = row * n + s;
            const std::uint32_t b = row * n + (s + 1) % n;
            add_triangle(mesh, a, b, b + n);
            add_triangle(mesh, a, b + n, a + n);
        }
    }
    return mesh;
}

Mesh cylinder(double radius_m, double z0_m, double z1_m, double chamfer_m) {
    return lathe({{radius_m - chamfer_m, z0_m},
                  {radius_m, z0_m + chamfer_m},
                  {radius_m, z1_m - chamfer_m},
                  {radius_m - chamfer_m, z1_m}});
}

Mesh cone(double radius0_m, double radius1_m, double z0_m, double z1_m) {
    return lathe({{radius0_m, z0_m}, {radius1_m, z1_m}});
}

Mesh sphere(double radius_m) {
    return lathe(arc(radius_m, 0.0, -std::numbers::pi / 2.0, std::numbers::pi / 2.0));
}

Mesh capsule(double radius_m, double length_m) {
    auto profile = arc(radius_m, 0.0, -std::numbers::pi / 2.0, 0.0);
    for (const auto& p : arc(radius_m, length_m, 0.0, std::numbers::pi / 2.0)) profile.push_back(p);
    return lathe(profile);
}

Mesh extrusion(const std::vector<Eigen::Vector2d>& polygon_m, double z0_m, double z1_m) {
    Mesh mesh;
    const auto n = static_cast<std::uint32_t>(polygon_m.size());
    for (const auto& p : polygon_m) mesh.vertices.emplace_back(p.x(), p.y(), z0_m);
    for (const auto& p : polygon_m) mesh.vertices.emplace_back(p.x(), p.y(), z1_m);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        add_triangle(mesh, i, j, j + n);
        add_triangle(mesh, i, j + n, i + n);
    }
    for (const auto& [a, b, c] : triangulated(polygon_m)) {
        add_triangle(mesh, a, c, b);
        add_triangle(mesh, a + n, b + n, c + n);
    }
    return mesh;
}

}  // namespace gripscan::sim
