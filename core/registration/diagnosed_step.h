// One step from two prepared views to a judged row of Table 1 with its evidence.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/registration/axis_estimate.h"
#include "core/registration/step_finding.h"
#include "core/registration/turn_settings.h"
#include "core/registration/turn_view.h"

namespace gripscan {

/// A capture at one end of a step.
struct StepEnd {
    const CaptureFacts& facts;
    const PreparedView& view;
    const std::optional<ImageFault>& fault;  ///< of its images against the others'
};

struct DiagnosedStep {
    TurnStep step;  ///< its index is left to the caller
    StepEvidence evidence;
};

/// The row as far as it does not need the common axis; not judged. A step locked to the axis has no
/// row yet.
[[nodiscard]] TurnStep measured_step(const StepEnd& from, const StepEnd& to,
                                     const StepFinding& finding, const TurnSettings& settings);

/// The whole row: compared with the axis, looked at for what is not explained, diagnosed; the
/// operator's note overrules. Without an axis the step speaks for itself.
[[nodiscard]] DiagnosedStep diagnosed_step(const StepEnd& from, const StepEnd& to,
                                           const StepFinding& finding,
                                           const std::optional<AxisEstimate>& axis,
                                           const TurnSettings& settings);

/// Of every view that has images, against those of the others.
[[nodiscard]] std::vector<std::optional<ImageFault>> image_faults(
    std::span<const PreparedView* const> views);

}  // namespace gripscan
