// What the mouse points at in the 3D view.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace gripscan::ui {

struct CursorReading {
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  ///< in the frame that is shown
    std::optional<double> residual_m;
    std::optional<int> step;
};

}  // namespace gripscan::ui
