// A part on a gripper as clouds, made by formula: what the pictures of the 3D view show.
#pragma once

#include <vector>

#include "ui/render/line_batch.h"
#include "ui/render/point_chunk.h"
#include "ui/theme/theme.h"

namespace gripscan::test {

/// A cylinder with a block on it and two legs, 0.7 m before the camera, in `steps` chunks of
/// points each seen from another side; `points` in all.
[[nodiscard]] std::vector<ui::PointChunk> synthetic_part(std::size_t points, int steps);

/// Registration area, gripper cuboid, joint axis with the turn so far, arm, floor, frustum.
[[nodiscard]] ui::LineBatch synthetic_lines(const ui::Theme& theme, const Eigen::Vector3d& eye_m);

}  // namespace gripscan::test
