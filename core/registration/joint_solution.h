// All captures at once: one shared axis, the robot's angles as measurements, and the surfaces of
// all neighbouring views, solved together.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/registration/surface.h"
#include "core/registration/turn_report.h"

namespace gripscan {

struct JointView {
    const Surface* surface = nullptr;  ///< camera frame
    double angle_rad = 0.0;            ///< turn since the first view as the robot reports it
    double sigma_rad = 0.0;            ///< standard deviation of that
};

struct JointSettings {
    std::size_t points = 2000;         ///< of a view in a pair
    double reach_rad = 1.2;            ///< pairs of views up to this far apart are matched
    int neighbours = 6;                ///< at most so many on each side
    double sigma_off_axis_rad = 2e-4;  ///< how exactly the arm turns about one line: its wobble
    double sigma_shift_m = 3e-5;       ///< and its repeatability
    bool scale_known = false;          ///< 1: nothing of the scale is estimated
};

struct JointSolution {
    AxisEstimate axis;
    /// T_camera_first: the part of the first view, as it stands in view k.
    std::vector<Pose> T_view_first;
    double scale = 1.0;  ///< of the robot's angles: true turn = scale · reported
    double scale_sigma = 0.0;
    bool scale_estimated = false;  ///< false: 1 was within its uncertainty and is kept
};

/// Gauss–Newton over the poses of all views (first one fixed), the axis, and the robot's scale and
/// offset; correspondences are found anew in every round (after Pulli 1999, with the known
/// structure of the motion as a prior). Error: cancelled.
[[nodiscard]] Result<JointSolution> solve_jointly(std::span<const JointView> views,
                                                  const Axis& start, const JointSettings& settings,
                                                  const Progress& progress,
                                                  const ForEach& for_each);

}  // namespace gripscan
