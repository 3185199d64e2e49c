// The axis of joint 6 from the few small turns of a warm-up.
#pragma once

#include <span>
#include <vector>

#include "core/procedure/input.h"
#include "core/procedure/turn_workspace.h"

namespace gripscan {

struct WarmUpAxis {
    event::AxisFound found;
    /// -1: the scans turned the other way than joint 6 reports, by the hint. What stands still and
    /// what turns has to be told by the scans' own sense.
    double sense = 1.0;
};

/// `shots` in order of the turns, all upwards; they are added to the workspace. A surface that does
/// not show its turn is no error: then there is no axis, and the sentence says so. Errors: captures
/// that cannot be prepared, cancelled.
[[nodiscard]] Result<WarmUpAxis> find_axis(std::span<const RecordedCapture> shots,
                                           TurnWorkspace& workspace,
                                           const std::optional<Eigen::Vector3d>& axis_hint,
                                           const Progress& progress, const ForEach& for_each);

}  // namespace gripscan
