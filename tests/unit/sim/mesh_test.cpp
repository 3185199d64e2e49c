#include "core/sim/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/sim/arm_model.h"
#include "core/sim/grippers.h"
#include "core/sim/objects.h"
#include "core/sim/surface_samples.h"

namespace gripscan::sim {
namespace {

using Key = std::array<long, 3>;

Key key_of(const Eigen::Vector3d& p) {
    constexpr double kGrid_m = 1e-8;  // corners that fall together have one place
    return {std::lround(p.x() / kGrid_m), std::lround(p.y() / kGrid_m),
            std::lround(p.z() / kGrid_m)};
}

/// Every edge is run through as often in one direction as in the other: no holes, no face that
/// looks inwards.
bool is_closed(const Mesh& mesh) {
    std::map<std::pair<Key, Key>, int> edges;
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Key a = key_of(mesh.vertices[t[i]]);
            const Key b = key_of(mesh.vertices[t[(i + 1) % 3]]);
            ++edges[{a, b}];
            --edges[{b, a}];
        }
    }
    return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

/// By the divergence theorem; negative where triangles look inwards.
double volume_m3(const Mesh& mesh) {
    double six = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        six += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
    }
    return six / 6.0;
}

TEST(Mesh, SolidsAreClosedAndHaveTheirVolume) {
    const double pi = std::numbers::pi;
    const double h = 1e-5;  // chamfers that hardly matter
    EXPECT_NEAR(volume_m3(chamfered_box({0.2, 0.1, 0.05}, h)), 1e-3, 1e-7);
    // A polygon of 96 sides has 0.07 % less area than its circle.
    EXPECT_NEAR(volume_m3(cylinder(0.05, -0.1, 0.2, h)), pi * 0.0025 * 0.3, 2e-6);
    EXPECT_NEAR(volume_m3(cone(0.03, 0.0, 0.0, 0.1)), pi * 0.0009 * 0.1 / 3.0, 1e-7);
    // Chords of 7.5° along the meridian take 0.4 % more.
    EXPECT_NEAR(volume_m3(sphere(0.05)), 4.0 / 3.0 * pi * 1.25e-4, 3e-6);
    EXPECT_NEAR(volume_m3(capsule(0.02, 0.1)), pi * 4e-4 * (0.1 + 4.0 / 3.0 * 0.02), 5e-7);
    // An L: its inner corner is what ear clipping must not cover.
    const std::vector<Eigen::Vector2d> l = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    EXPECT_NEAR(volume_m3(extrusion(l, -1.0, 1.0)), 10.0, 1e-12);
    for (const Mesh& mesh :
         {chamfered_box({0.2, 0.1, 0.05}, 0.004), cylinder(0.05, 0, 0.1), cone(0.03, 0.0, 0.0, 0.1),
          sphere(0.05), capsule(0.02, 0.1), extrusion(l, -1.0, 1.0)}) {
        EXPECT_TRUE(is_closed(mesh));
    }
}

TEST(Mesh, EveryBuiltInPartIsClosedAndLooksOutwards) {
    std::vector<Part> parts;
    for (const auto& name : gripper_names()) {
        for (Part& part : make_gripper(name).parts) parts.push_back(std::move(part));
    }
    for (const auto& name : object_names()) {
        for (const double opening_m : {0.0, 0.044}) {
            for (Part& part : make_object(name, opening_m)) parts.push_back(std::move(part));
        }
    }
    for (auto& link : make_arm()) parts.insert(parts.end(), link.begin(), link.end());
    EXPECT_GT(parts.size(), 60U);
    for (const Part& part : parts) {
        EXPECT_TRUE(is_closed(part.mesh)) << part.name;
        EXPECT_GT(volume_m3(part.mesh), 1e-7) << part.name;
    }
}

TEST(SurfaceSamples, LieOnTheSurfaceOnePerSquareOfTheSpacing) {
    const Mesh mesh = chamfered_box({0.10, 0.06, 0.04}, 0.002);
    const double area_m2 = 2 * (0.10 * 0.06 + 0.10 * 0.04 + 0.06 * 0.04);
    const auto samples = sample_surface(mesh, 0.001);
    // Cut edges make the surface a little smaller.
    EXPECT_NEAR(static_cast<double>(samples.size()), area_m2 / 1e-6, 0.05 * area_m2 / 1e-6);
    for (const SurfaceSample& sample : samples) {
        const Eigen::Vector3d beyond =
            sample.point_m.cwiseAbs() - Eigen::Vector3d(0.05, 0.03, 0.02);
        EXPECT_LT(beyond.maxCoeff(), 1e-12);
        EXPECT_GT(beyond.maxCoeff(), -0.002);
        EXPECT_GT(sample.normal.dot(sample.point_m), 0.0);
    }
}

}  // namespace
}  // namespace gripscan::sim
