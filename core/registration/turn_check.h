// The check of a step against the robot by its numbers: the limits of the contract.
#pragma once

#include "core/registration/step_evidence.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// A limit may be missed by this factor before "check" becomes "reject".
inline constexpr double kCheckFactor = 2.0;
/// Readings of a joint that stands still differ by less than this (encoder, rounding), rad.
inline constexpr double kJointStill_rad = 0.02 * 0.017453292519943295;
/// Under the robot's own turn so much of the surface may float where the other camera looked
/// through; more speaks against that turn.
inline constexpr double kMostFloating = 0.06;
/// Residuals under an axis-locked turn may be this many times what the noise predicts.
inline constexpr double kMostMisfit = 3.0;

/// What an angle's error may be: the limit, or so many sigmas of the estimate.
[[nodiscard]] double angle_limit_rad(const TurnStep& step, const TurnLimits& limits);

/// If the part turned as the robot says, and nothing seen speaks against that, the views share less
/// than the limit.
[[nodiscard]] bool step_too_large(const StepEvidence& evidence, const TurnLimits& limits);

/// Sets verdict, cause and sentence of one step from its numbers alone (contract: accept within
/// all limits, check below twice a limit or when not independent, reject beyond).
void judge_step(TurnStep& step, const StepEvidence& evidence, const TurnLimits& limits);

}  // namespace gripscan
