// The result of a stereo calibration as JSON, as `calibrate stereo --json` prints it.
#pragma once

#include <string>

#include "core/stereo/calibrate.h"

namespace gripscan {

/// `rig_path`: where the rig was written; empty if it was not.
[[nodiscard]] std::string calibration_json(const CalibrationResult& result,
                                           const std::string& rig_path);

}  // namespace gripscan
