#include "core/cloud/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/seeded_random.h"

namespace gripscan {
namespace {

/// Twice the area times the outward normal.
Eigen::Vector3d cross_of(const TriangleMesh& mesh, const Triangle& t) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
}

/// Area of all triangles up to and including each.
std::vector<double> area_up_to(const TriangleMesh& mesh) {
    std::vector<double> sums;
    sums.reserve(mesh.triangles.size());
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const double area = 0.5 * cross_of(mesh, t).norm();
        if (std::isfinite(area)) sum += area;
        sums.push_back(sum);
    }
    return sums;
}

Eigen::Vector3d point_in(const TriangleMesh& mesh, const Triangle& t, SeededRandom& random) {
    // The square root makes the density even over the triangle (Osada et al. 2002, eq. 1).
    const double r = std::sqrt(random.uniform());
    const double s = random.uniform();
    return (1.0 - r) * mesh.vertices[t[0]] + r * (1.0 - s) * mesh.vertices[t[1]] +
           r * s * mesh.vertices[t[2]];
}

}  // namespace

Cloud sample_surface(const TriangleMesh& mesh, const MeshSampling& sampling) {
    Cloud cloud;
    const std::vector<double> area = area_up_to(mesh);
    if (area.empty() || !(area.back() > 0.0) || !std::isfinite(area.back())) return cloud;
    const double wanted = std::ceil(area.back() / (sampling.spacing_m * sampling.spacing_m));
    const auto n =
        static_cast<std::size_t>(std::min(wanted, static_cast<double>(sampling.max_points)));
    SeededRandom random(sampling.seed);
    auto place = area.begin();
    for (std::size_t i = 0; i < n; ++i) {
        // One draw from each of n equal shares of the area: evener than n free draws.
        const double at = (static_cast<double>(i) + random.uniform()) / static_cast<double>(n);
        place = std::upper_bound(place, area.end() - 1, at * area.back());
        const Triangle& t = mesh.triangles[static_cast<std::size_t>(place - area.begin())];
        const Eigen::Vector3d p = point_in(mesh, t, random);
        const Eigen::Vector3d n_outward = cross_of(mesh, t).normalized();
        if (!p.cast<float>().allFinite() || !n_outward.allFinite()) continue;
        cloud.points.push_back(p.cast<float>());
        cloud.normals.push_back(n_outward.cast<float>());
    }
    return cloud;
}

}  // namespace gripscan
