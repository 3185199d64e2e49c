// Does a held part stay where it was gripped? The part registered against the part, the gripper
// against the gripper, and what remains between the two motions.
#pragma once

#include <optional>

#include "core/registration/align.h"
#include "core/registration/turn_report.h"
#include "core/registration/turn_view.h"

namespace gripscan {

/// `part` maps the held part of `from` onto that of `to`. Nothing where the gripper is not measured
/// in both views. The gripper is aligned from where its template was found in the two views.
[[nodiscard]] std::optional<GripSlip> measure_grip_slip(const PreparedView& from,
                                                        const PreparedView& to,
                                                        const Alignment& part,
                                                        const AlignSettings& settings);

/// A held part may seem to move by this: half of the limit for a part on the flange, since both
/// motions come from the same pictures, or so many standard deviations.
[[nodiscard]] double grip_shift_limit_m(const GripSlip& slip, const TurnLimits& limits);
/// The same of its angle: that of a step's error.
[[nodiscard]] double grip_angle_limit_rad(const GripSlip& slip, const TurnLimits& limits);

[[nodiscard]] bool slipped(const GripSlip& slip, const TurnLimits& limits);

}  // namespace gripscan
