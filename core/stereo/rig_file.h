// rig.yaml: a stereo rig as OpenCV's FileStorage writes it.
#pragma once

#include <filesystem>

#include "core/geometry/stereo_rig.h"

namespace gripscan {

/// Reads and validates. The message names the file, the key and what is wrong.
[[nodiscard]] Result<StereoRig> load_rig(const std::filesystem::path& path);
[[nodiscard]] Status save_rig(const std::filesystem::path& path, const StereoRig& rig);

}  // namespace gripscan
