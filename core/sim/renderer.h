// One camera's exposure without the sensor: brightness by ray tracing, several rays a pixel.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "core/base/for_each.h"
#include "core/sim/lens.h"
#include "core/sim/shader.h"

namespace gripscan::sim {

/// Whose eye it is, and where it looks closely: with 9 rays a pixel, one somewhere in each cell of
/// a grid of 3 × 3; elsewhere with 2, in opposite cells of 2 × 2. The seed and the pixel alone
/// decide where in its cell a ray goes.
struct Viewpoint {
    const Lens* lens = nullptr;
    Pose T_world_camera = Pose::Identity();
    cv::Rect dense;  ///< where the gripper may be seen
    std::uint64_t jitter_seed = 0;
};

struct Picture {
    cv::Mat brightness;  ///< CV_32F levels
    cv::Mat live;        ///< CV_8U, not 0 where the brightness may change as joint 6 turns
};

/// Every pixel. The same for any number of threads.
[[nodiscard]] Picture render_all(const Shader& shader, const Viewpoint& view,
                                 const ForEach& for_each);

/// Renders the live pixels again, for another angle of joint 6: the picture is then the same as
/// from render_all(), at a fraction of the time.
void render_live(const Shader& shader, const Viewpoint& view, Picture& picture,
                 const ForEach& for_each);

}  // namespace gripscan::sim
