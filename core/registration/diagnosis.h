// From evidence to exactly one cause and one sentence.
#pragma once

#include "core/registration/step_evidence.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// The background may seem to move by this much, px: sensor noise leaves some hundredths, a camera
/// that was touched moves by several.
inline constexpr double kMostCameraShift_px = 0.5;
/// The largest piece of surface the other view may miss, in squared rms radii of the part: 380
/// healthy steps missed up to 0.08, a rod 40 mm thick beside a gripper is at least 0.22.
inline constexpr double kMostUnexplained = 0.14;

/// Judges the numbers (judge_step), then names what explains them, the outermost cause first:
/// a camera that moved, an object that does not belong there, a part that moved in the gripper that
/// holds it, a wrong joint or one not settled,
/// bad images, then what the numbers themselves say. A moved camera and a foreign object reject
/// even a step whose angle agrees; bad images of the newer view want another attempt though its
/// numbers hold (check), and reject where too little of the surface is left. Sets
/// evidence.foreign_object.
void diagnose_step(TurnStep& step, StepEvidence& evidence, const TurnLimits& limits);

/// The background moved more than a still camera's.
[[nodiscard]] bool camera_moved(const StepEvidence& evidence);
/// A piece larger than its limit is not explained.
[[nodiscard]] bool much_unexplained(const StepEvidence& evidence);

}  // namespace gripscan
