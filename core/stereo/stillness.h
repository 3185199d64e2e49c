// Do two exposures of the same view agree? What still moves between them is told from sensor noise.
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <optional>

namespace gripscan {

struct Stillness {
    double motion_px = 0.0;      ///< rms motion of the textured blocks, noise taken off
    double least_seen_px = 0.0;  ///< motion that would just be told from the noise (3 sigma)
    double noise_levels = 0.0;   ///< standard deviation of one image, as the two show it
    int blocks = 0;              ///< with enough texture
    /// Nothing moved that could have been seen.
    [[nodiscard]] bool still() const { return motion_px <= least_seen_px; }
};

/// Two 8-bit grey images of one camera, compared inside `area` in blocks of 24 px: each block's
/// motion by least squares on its gradients, brightness offset free. What can be seen depends on
/// the texture and is in the result: with a contrast of 14 levels, noise of 2 and some fifty
/// blocks, about 0.01 px. Motions beyond a pixel are seen, but not measured well. Nothing if fewer
/// than four blocks have texture or the images differ in size.
[[nodiscard]] std::optional<Stillness> stillness(const cv::Mat& first, const cv::Mat& second,
                                                 const cv::Rect& area);

}  // namespace gripscan
