// Did the camera move? The still background, seen beside the registration area, tells.
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <optional>

namespace gripscan {

/// What is kept of a capture for later comparison: its left image at half the resolution, and the
/// part of it that belongs to the registration area and its surroundings.
struct Background {
    cv::Mat half;       ///< CV_8UC1
    cv::Rect excluded;  ///< px of `half`
};

/// `area` is the image of the registration area in `left` (rectified, 8-bit grey).
[[nodiscard]] Background background_of(const cv::Mat& left, const cv::Rect& area);

/// How far the background moved, px of the full image.
struct BackgroundShift {
    double shift_px = 0.0;  ///< median length of the patches' shifts, their noise taken off
    double noise_px = 0.0;  ///< of one patch: by how much neighbours differ
    double agreeing = 0.0;  ///< share of all patches on the median's side of half a pixel
    int patches = 0;        ///< found again
};

/// Compares textured patches spread over the background, each found again by normalised cross
/// correlation within ±32 px, so that exposure does not matter. Nothing if fewer than twelve are
/// found, if they lie in one corner only, or if the images differ in size. A minority that moves
/// (a cable, a shadow, a person) does not move the median.
[[nodiscard]] std::optional<BackgroundShift> background_shift(const Background& before,
                                                              const Background& now);

}  // namespace gripscan
