// What is left in the registration area once everything known is taken away: things in the way.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/cloud/cloud.h"
#include "core/geometry/pose.h"

namespace gripscan {

/// A thing that may be there: points on its surface and where they are now.
struct KnownThing {
    const Cloud* cloud = nullptr;
    Pose T_camera_cloud = Pose::Identity();
    double margin_m = 0.005;  ///< points of the scene this near belong to it
};

struct LeftOverSettings {
    double gap_m = 0.008;  ///< points further apart than this belong to different things
    std::size_t least_points = 60;
    double least_size_m = 0.010;  ///< a smaller piece is noise
};

/// One thing in the way.
struct LeftOver {
    std::vector<std::size_t> points;                     ///< indices in the scene
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< mean of the points, camera frame
    /// Extents along its own axes, largest first; what the camera does not see is missing.
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, in the same order
};

/// Those of `indices` that belong to none of the things.
[[nodiscard]] std::vector<std::size_t> without_known(const Cloud& scene,
                                                     const std::vector<std::size_t>& indices,
                                                     std::span<const KnownThing> things);

/// Connected pieces of the named points, those with most points first.
[[nodiscard]] std::vector<LeftOver> find_left_overs(const Cloud& scene,
                                                    const std::vector<std::size_t>& indices,
                                                    const LeftOverSettings& settings);

/// "something is in the way: 150 x 26 x 11 mm at x 12, y 83, z 640 mm".
[[nodiscard]] std::string sentence(const LeftOver& thing);

}  // namespace gripscan
