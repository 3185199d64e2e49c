// How a gripper's template sits on the flange.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/geometry/pose.h"

namespace gripscan::app {

/// T_tool_template of a session's template: from the alignment and the joints at its first used
/// capture, in whose camera frame the template is. Errors: no session, joints not recorded.
[[nodiscard]] Result<Pose> tool_frame(const std::filesystem::path& session,
                                      const std::filesystem::path& alignment);

}  // namespace gripscan::app
