// Things of the cell as lines.
#pragma once

#include "core/geometry/axis.h"
#include "core/geometry/box.h"
#include "core/geometry/pose.h"
#include "core/geometry/stereo_rig.h"
#include "ui/render/line_batch.h"

namespace gripscan::ui {

/// The twelve edges.
void add_box(LineBatch& lines, const Box& box, const Pose& T_world_box, const LineStyle& style);

/// The axis from `from_m` to `to_m` along its direction.
void add_axis(LineBatch& lines, const Axis& axis, double from_m, double to_m,
              const LineStyle& style);

/// The way of `start_m` about the axis, from one angle to another.
void add_arc(LineBatch& lines, const Axis& axis, const Eigen::Vector3d& start_m, double from_rad,
             double to_rad, const LineStyle& style);

/// What the left camera sees, up to a depth: four rays and the picture's frame there.
void add_frustum(LineBatch& lines, const RectifiedRig& rig, double depth_m, const LineStyle& style);

/// The outline of a capsule, as it is seen from `eye_m`: circles at its ends, its two sides.
void add_capsule(LineBatch& lines, const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m,
                 double radius_m, const Eigen::Vector3d& eye_m, const LineStyle& style);

/// A square grid in the plane through `centre_m` with the given normal.
void add_grid(LineBatch& lines, const Eigen::Vector3d& centre_m, const Eigen::Vector3d& normal,
              double half_m, double cell_m, const LineStyle& style);

/// Three short lines through a point, along the world's axes: the pivot.
void add_cross(LineBatch& lines, const Eigen::Vector3d& at_m, double half_m,
               const LineStyle& style);

}  // namespace gripscan::ui
