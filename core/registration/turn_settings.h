// How a turn is solved: the method, its limits, and what is known of the cell.
#pragma once

#include <optional>

#include "core/geometry/box.h"
#include "core/registration/align.h"
#include "core/registration/turn_report.h"

namespace gripscan {

enum class TurnMethod { kTurn, kPaperIcp };

struct TurnSettings {
    TurnMethod method = TurnMethod::kTurn;
    AlignSettings align;
    PaperIcpSettings paper_icp;
    TurnLimits limits;
    double step_rad = 0.17453292519943295;     ///< nominal
    std::optional<Eigen::Vector3d> axis_hint;  ///< direction of the positive turn
    /// The axis as a warm-up found it: for steps locked to it before free ones have shown it, and
    /// for the first step's deviations.
    std::optional<AxisEstimate> known_axis;
    /// What the clouds were cut to: a point outside it is in no cloud. Nothing: not known.
    std::optional<Box> region;
    double voxel_m = 1.0e-3;  ///< of the template
    int min_seen = 2;         ///< views that must have seen a template point
};

}  // namespace gripscan
