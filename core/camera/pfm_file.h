// Disparities as PFM files: float32, rows bottom-up, scale −1 (little endian), unknown = +inf.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "core/base/result.h"

namespace gripscan {

/// CV_32F, one channel; the file appears whole or not at all.
[[nodiscard]] Status save_pfm(const std::filesystem::path& path, const cv::Mat& image);

/// The floats as they stand (the scale only tells the byte order), rows top-down.
[[nodiscard]] Result<cv::Mat> load_pfm(const std::filesystem::path& path);

}  // namespace gripscan
