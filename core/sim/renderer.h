// One camera's exposure without the sensor: brightness by ray tracing, several rays a pixel.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "core/base/for_each.h"
#include "core/sim/lens.h"
#include "core/sim/shader.h"

namespace gripscan::sim {

struct Viewpoint {
    const Lens* lens = nullptr;
    Pose T_world_camera = Pose::Identity();
    std::uint64_t jitter_seed = 0;
};

/// Rays a pixel, each in its own cell of a grid within the pixel: `inside` the rectangle (which
/// holds the gripper) and outside. Squares of whole numbers.
struct Sampling {
    cv::Rect dense;
    int rays_dense = 9;
    int rays_else = 4;
};

/// CV_32F levels. The same for any number of threads.
[[nodiscard]] cv::Mat render(const Shader& shader, const Viewpoint& view, const Sampling& sampling,
                             const ForEach& for_each);

}  // namespace gripscan::sim
