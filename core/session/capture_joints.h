// The joints of a line of captures.csv, in the code's units.
#pragma once

#include <optional>

#include "core/robot/robot_link.h"
#include "core/session/capture_table.h"

namespace gripscan {

/// All six as read before the exposure; nothing where one is missing.
[[nodiscard]] std::optional<JointAngles> joints_rad(const CaptureRow& row);

}  // namespace gripscan
