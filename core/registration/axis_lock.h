// Steps whose turn the surface does not show: turned by the robot's angle about an axis that the
// data give, and looked at whether the surfaces agree with that.
#pragma once

#include <optional>
#include <span>

#include "core/registration/align.h"
#include "core/registration/axis_estimate.h"
#include "core/registration/turn_settings.h"
#include "core/registration/turn_view.h"

namespace gripscan {

[[nodiscard]] bool any_locked(std::span<const CaptureFacts> facts);

/// The axis for locked steps: starts at `free` (from the free steps), else at the known axis of the
/// settings, else at that of the surface of revolution, its sign from the hint; then refined by
/// solving all usable views jointly with the angles known. Nothing if there is no start. Error:
/// cancelled.
[[nodiscard]] Result<std::optional<AxisEstimate>> axis_for_lock(
    std::span<const CaptureFacts> facts, std::span<const PreparedView* const> views,
    const std::optional<AxisEstimate>& free, const TurnSettings& settings, const Progress& progress,
    const ForEach& for_each);

/// How the surfaces fit when the part turns by `angle_rad` about the axis.
[[nodiscard]] Alignment locked_alignment(const PreparedView& from, const PreparedView& to,
                                         const std::optional<AxisEstimate>& axis,
                                         std::optional<double> angle_rad,
                                         const AlignSettings& settings);

}  // namespace gripscan
