// Does the environment still stand where it was learned? A rigid shift of everything that does not
// belong to the arm, or, which looks the same, of the camera.
#pragma once

#include "core/base/progress.h"
#include "core/scene/environment_model.h"

namespace gripscan {

struct ShiftSettings {
    double reach_m = 0.030;   ///< points that are further from the environment are something else
    double least_m = 0.0005;  ///< a smaller shift is not worth a word
    double sigmas = 5.0;      ///< nor is one within so many of its standard deviations
};

/// Of the environment since it was learned, in the camera frame.
struct EnvironmentShift {
    Pose T_model_scene = Pose::Identity();  ///< brings the scene back to where it was learned
    Eigen::Vector3d at_m = Eigen::Vector3d::Zero();     ///< middle of what was compared
    Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  ///< of that place, then → now
    double turn_rad = 0.0;
    double sd_m = 0.0;       ///< of the shift's length
    double sd_rad = 0.0;     ///< of the turn
    std::size_t places = 0;  ///< compared; too few: nothing is known
    double agreeing = 0.0;   ///< share of the environment's pixels that the shift explains
    bool known = false;
    bool moved = false;  ///< beyond the limits
};

/// Compares depth and brightness of the organised scene with what was learned, from coarse to fine,
/// robustly: what stands before the environment does not count. Errors: as
/// EnvironmentModel::fits(), a cloud without a grid, cancelled.
[[nodiscard]] Result<EnvironmentShift> environment_shift(const EnvironmentModel& model,
                                                         const Cloud& scene,
                                                         const ShiftSettings& settings,
                                                         const Progress& progress,
                                                         const ForEach& for_each);

}  // namespace gripscan
