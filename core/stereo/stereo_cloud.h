// From a rectified stereo pair to a cloud: the chain match → refine → reject → triangulate.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/camera/stereo_source.h"
#include "core/cloud/cloud.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"

namespace gripscan {

struct StereoSettings {
    /// Disparity range, px. Nothing: from the region, else from the rig (0 … width/4).
    std::optional<int> min_disparity;
    std::optional<int> num_disparities;
    bool refine = true;  ///< sub-pixel refinement against pixel locking
    bool reject_silhouettes = true;
    bool crop_to_region = true;  ///< after matching
};

/// How well the pair could be used, inside the region where there is one.
struct StereoHealth {
    /// Share of textured pixels with a disparity. With a region, textured background behind it
    /// counts as not found: compare captures of one cell, not cells.
    double fill = 0.0;
    double mean_intensity = 0.0;  ///< 0 … 255
    double saturated = 0.0;       ///< share of pixels at 255 (or 0)
    double texture = 0.0;         ///< median local contrast (standard deviation), levels
    double row_error_px = 0.0;    ///< median vertical shift between the images
    double glare = 0.0;           ///< share of pixels at the upper end of the scale
    /// Structure of one to two pixels over that of two to four, where there is any: falls when the
    /// lens is out of focus, whatever the light.
    double sharpness = 0.0;
    double contrast = 0.0;  ///< local contrast where stereo found a surface, levels
};

struct StereoCloud {
    Cloud cloud;        ///< organised, with normals, intensity, sigma; viewpoint at the origin
    cv::Mat disparity;  ///< CV_32F of the full image, +inf where unknown
    StereoHealth health;
};

/// Errors: images that differ in size from the rig, a region that no camera sees, cancelled.
[[nodiscard]] Result<StereoCloud> stereo_cloud(const StereoFrame& rectified,
                                               const RectifiedRig& rig,
                                               const std::optional<Box>& region,
                                               const StereoSettings& settings,
                                               const Progress& progress, const ForEach& for_each);

}  // namespace gripscan
