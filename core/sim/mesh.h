// Triangle meshes from which the simulated cell is built, and solids as such meshes.
// Lengths in m; triangles are counter-clockwise seen from outside.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/pose.h"

namespace gripscan::sim {

struct Mesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

void append(Mesh& mesh, const Mesh& more, const Pose& T_mesh_more = Pose::Identity());
[[nodiscard]] Mesh moved(const Mesh& mesh, const Pose& T_target_mesh);

/// A frame at `origin` with its z along `z_direction`.
[[nodiscard]] Pose frame_at(const Eigen::Vector3d& origin,
                            const Eigen::Vector3d& z_direction = Eigen::Vector3d::UnitZ());

/// Centred on the origin; all twelve edges are cut at 45°. chamfer > 0.
[[nodiscard]] Mesh chamfered_box(const Eigen::Vector3d& size_m, double chamfer_m);

/// The profile (radius, z), z rising, revolved about z and closed by caps where radius > 0.
[[nodiscard]] Mesh lathe(const std::vector<Eigen::Vector2d>& profile_m, int segments = 96);

/// Along z from z0 to z1, both rims cut at 45°.
[[nodiscard]] Mesh cylinder(double radius_m, double z0_m, double z1_m, double chamfer_m = 0.001);
[[nodiscard]] Mesh cone(double radius0_m, double radius1_m, double z0_m, double z1_m);
[[nodiscard]] Mesh sphere(double radius_m);
/// Half spheres around the origin and around (0, 0, length).
[[nodiscard]] Mesh capsule(double radius_m, double length_m);

/// A simple polygon (x, y), counter-clockwise, extruded from z0 to z1.
[[nodiscard]] Mesh extrusion(const std::vector<Eigen::Vector2d>& polygon_m, double z0_m,
                             double z1_m);

}  // namespace gripscan::sim
