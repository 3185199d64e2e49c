// A small ray caster for tests of stereo: planes and spheres with a solid texture, seen by a
// rectified pair, blurred and with noise; the disparity of every left pixel is known exactly.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "core/camera/stereo_source.h"
#include "core/geometry/stereo_rig.h"

namespace gripscan::test {

/// All points with normal · x = offset.
struct PlaneSurface {
    Eigen::Vector3d normal;
    double offset_m;
};

struct SphereSurface {
    Eigen::Vector3d centre_m;
    double radius_m;
};

struct RayScene {
    std::vector<PlaneSurface> planes;
    std::vector<SphereSurface> spheres;
    double grain_m = 2.0e-3;  ///< size of the finest texture
    double contrast = 60.0;   ///< of the texture, levels (about twice its standard deviation)
    std::uint64_t seed = 1;
};

struct CameraNoise {
    double blur_px = 0.6;
    double noise_levels = 2.0;
    double right_gain = 1.0;  ///< the right camera may see everything brighter
    double right_offset = 0.0;
};

struct RenderedPair {
    StereoFrame frame;
    cv::Mat1f disparity;  ///< px, +inf where nothing is hit
    cv::Mat1b visible_in_both;
    cv::Mat1i surface;  ///< which one was hit: planes first, then spheres; −1 none
};

[[nodiscard]] RenderedPair render(const RayScene& scene, const RectifiedRig& rig,
                                  const CameraNoise& noise);

/// f 985 px, baseline 0.12 m, as the cells of the paper.
[[nodiscard]] RectifiedRig cell_rig(int width, int height);

}  // namespace gripscan::test
