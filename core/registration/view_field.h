// What a camera can see at all: the image as slopes of viewing rays.
#pragma once

#include <Eigen/Core>

namespace gripscan {

/// Slopes x/z and y/z of the image's borders, camera in the origin looking along z. A point must
/// also appear in the second camera, `baseline_m` to the right, whose image ends at the same
/// slopes.
struct ViewField {
    Eigen::Vector2d min = Eigen::Vector2d::Constant(-1e9);
    Eigen::Vector2d max = Eigen::Vector2d::Constant(1e9);
    double baseline_m = 0.0;

    [[nodiscard]] bool sees(const Eigen::Vector3d& p_m) const {
        if (p_m.z() <= 0.0) return false;
        const double v = p_m.y() / p_m.z();
        return p_m.x() / p_m.z() <= max.x() && (p_m.x() - baseline_m) / p_m.z() >= min.x() &&
               v >= min.y() && v <= max.y();
    }
};

}  // namespace gripscan
