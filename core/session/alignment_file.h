// The robot-camera alignment in a file: 16 numbers T_robot_camera under the key `alignment`, as
// `calibrate robot` writes it and a cell file holds it.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/geometry/pose.h"

namespace gripscan {

/// Other keys are left alone. The message names file, line and reason.
[[nodiscard]] Result<Pose> load_alignment(const std::filesystem::path& path);

}  // namespace gripscan
