// The plane through a handful of points.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace gripscan {

struct PlaneFit {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit vector of either sign
    double variance_m2 = 0.0;  ///< of the points along it, for three fitted parameters
};

/// Least squares; nothing for fewer than three points or points on a line.
[[nodiscard]] std::optional<PlaneFit> fit_plane(std::span<const Eigen::Vector3f> points);

}  // namespace gripscan
