// A box that stands in space as it likes: what encloses a gripper or an object.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "core/geometry/pose.h"

namespace gripscan {

struct OrientedCuboid {
    Pose T_frame_cuboid = Pose::Identity();  ///< its origin is the cuboid's centre
    Eigen::Vector3d half_m = Eigen::Vector3d::Zero();

    [[nodiscard]] Eigen::Vector3d size_m() const { return 2.0 * half_m; }
    [[nodiscard]] double volume_m3() const { return size_m().prod(); }
    [[nodiscard]] bool contains(const Eigen::Vector3d& p_m) const {
        return ((T_frame_cuboid.inverse() * p_m).cwiseAbs().array() <= half_m.array()).all();
    }
    /// Bit k of the number is the side along the cuboid's own axis k.
    [[nodiscard]] std::array<Eigen::Vector3d, 8> corners_m() const;
};

/// By which every face is moved outwards (inwards where negative), along the cuboid's own axes.
struct FaceMargins {
    Eigen::Vector3d low_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d high_m = Eigen::Vector3d::Zero();

    friend bool operator==(const FaceMargins&, const FaceMargins&) = default;
};

/// A face that would pass the opposite one meets it: the cuboid is then flat.
[[nodiscard]] OrientedCuboid widened(const OrientedCuboid& cuboid, const FaceMargins& margins);
/// The same cuboid, seen from another frame.
[[nodiscard]] OrientedCuboid moved(const OrientedCuboid& cuboid, const Pose& T_frame_own);

/// Encloses the points with its z along `direction` and the smallest cross-section, to a degree of
/// turn; x is the longer side of that. Of no points it is a point at the origin.
[[nodiscard]] OrientedCuboid cuboid_along(std::span<const Eigen::Vector3f> points_m,
                                          const Eigen::Vector3d& direction);
/// The smallest of those along the points' principal axes.
[[nodiscard]] OrientedCuboid cuboid_around(std::span<const Eigen::Vector3f> points_m);

}  // namespace gripscan
