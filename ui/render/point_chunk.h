// What the 3D view shows of the clouds: chunks that never change. Changed points come as the same
// id with another generation, and only then does the picture's memory take them anew.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/cloud/cloud.h"
#include "core/geometry/box.h"
#include "core/geometry/pose.h"
#include "ui/theme/colour.h"

namespace gripscan::ui {

struct PointChunk {
    std::uint64_t id = 0;
    std::uint64_t generation = 0;
    std::shared_ptr<const Cloud> cloud;
    std::shared_ptr<const std::vector<float>> residual_m;  ///< one a point; < 0: unknown
    Pose T_world_cloud = Pose::Identity();                 ///< may change without a new generation
    std::uint16_t step = 0;
    Colour colour{};  ///< of ColourBy::kChunk
    bool visible = true;
};

/// One point in the memory of the graphics card, 28 bytes.
struct PackedPoint {
    float x_m, y_m, z_m;
    std::int8_t nx, ny, nz;
    std::uint8_t intensity;
    std::uint16_t seen;
    std::uint16_t step;
    float residual_m;
    float sigma_m;
};
static_assert(sizeof(PackedPoint) == 28);

/// The points in an order that is random but the same every time: every beginning of it is an even
/// sample of the whole. What is not known is 0.
[[nodiscard]] std::vector<PackedPoint> packed_points(const PointChunk& chunk);

/// Around the points; not valid where there are none.
[[nodiscard]] Box bounds_of(std::span<const Eigen::Vector3f> points_m);

}  // namespace gripscan::ui
