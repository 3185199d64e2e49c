// The result of one stereo pair as JSON, as `stereo --json` prints it.
#pragma once

#include <string>

#include "core/stereo/stereo_cloud.h"

namespace gripscan {

/// `disparity_path` may be empty.
[[nodiscard]] std::string stereo_json(const StereoCloud& stereo, const std::string& cloud_path,
                                      const std::string& disparity_path);

}  // namespace gripscan
