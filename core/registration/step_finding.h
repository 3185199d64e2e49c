// What is found between two views once, whatever becomes of the turn: it is kept while captures
// come and go.
#pragma once

#include <functional>
#include <optional>

#include "core/registration/align.h"
#include "core/registration/step_evidence.h"

namespace gripscan {

/// Between the views at two places of the turn; nothing where too little background is seen.
using CameraShiftBetween =
    std::function<std::optional<CameraShift>(std::size_t from, std::size_t to)>;

/// What was found between two neighbouring views, before the common axis is known.
struct StepFinding {
    Alignment alignment;
    std::optional<CameraShift> camera_shift;
};

}  // namespace gripscan
