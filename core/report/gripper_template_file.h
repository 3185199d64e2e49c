// The gripper's template as it lies on the disk: the cloud, and beside it what its registration
// knew of axis and joint.
#pragma once

#include <filesystem>
#include <memory>

#include "core/base/result.h"
#include "core/scene/gripper_template.h"

namespace gripscan {

/// `named`: a cloud file, or the session folder that it was registered in; relative names are those
/// of files in `folder`. The sidecar (same name with .json) gives axis and joint, else turns.json
/// beside it the axis. Errors: no such file, no axis, too few points.
[[nodiscard]] Result<std::shared_ptr<const GripperTemplate>> load_gripper_template(
    const std::filesystem::path& folder, const std::string& named);

/// How a session shall name a template: by the way to it where both lie in the same folder, else
/// absolutely. A session folder stands for the template in its results.
[[nodiscard]] std::string name_of_template(const std::filesystem::path& session,
                                           const std::filesystem::path& given);

}  // namespace gripscan
