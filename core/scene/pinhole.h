// The camera that made an organised cloud, read off the cloud itself.
#pragma once

#include <optional>

#include "core/cloud/cloud.h"

namespace gripscan {

/// u = fu · x / z + cu, v = fv · y / z + cv; u and v count the columns and rows of the grid.
struct Pinhole {
    double fu_px = 0.0;
    double cu_px = 0.0;
    double fv_px = 0.0;
    double cv_px = 0.0;

    [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& p_m) const {
        return {fu_px * p_m.x() / p_m.z() + cu_px, fv_px * p_m.y() / p_m.z() + cv_px};
    }
    [[nodiscard]] Eigen::Vector3d point_m(double u_px, double v_px, double depth_m) const {
        return {(u_px - cu_px) * depth_m / fu_px, (v_px - cv_px) * depth_m / fv_px, depth_m};
    }
};

/// Nothing for a cloud without a grid, with fewer than 100 points, or one whose points do not lie
/// where a single camera sees them (to 0.1 px rms).
[[nodiscard]] std::optional<Pinhole> pinhole_of(const Cloud& cloud);

/// Largest of the median distances, in columns and in rows, between where the points' cells are and
/// where the camera would see them, px.
[[nodiscard]] double misfit_px(const Cloud& cloud, const Pinhole& camera);

}  // namespace gripscan
