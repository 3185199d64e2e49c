// A depth image, as depth cameras write it, as a cloud.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/cloud/cloud.h"

namespace gripscan {

/// A pinhole without distortion; pixel centres are whole numbers. metres = value / depth_scale.
struct DepthCamera {
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    double depth_scale = 1000.0;
};

/// Organised, viewpoint in the origin, x right, y down, z forward; 0 means not measured. Errors:
/// no image with one channel of 8 or 16 bits, a camera that makes no sense, no depth at all.
[[nodiscard]] Result<Cloud> load_depth_cloud(const std::filesystem::path& path,
                                             const DepthCamera& camera);

}  // namespace gripscan
