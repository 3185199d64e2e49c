// Images as files: 8-bit grey in memory, PNG on the disk.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "core/base/result.h"

namespace gripscan {

/// Any format OpenCV reads, turned into 8-bit grey. A file that is absent, no image or cut short is
/// an error that names it: libraries fill the missing part with grey and call that a success.
[[nodiscard]] Result<cv::Mat> load_grey_image(const std::filesystem::path& path);

/// Lossless; the file appears whole or not at all.
[[nodiscard]] Status save_png(const std::filesystem::path& path, const cv::Mat& image);

}  // namespace gripscan
