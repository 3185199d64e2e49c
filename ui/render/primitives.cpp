#include "ui/render/primitives.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscan::ui {
namespace {

using Eigen::Vector3d;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Any unit vector across a direction.
Vector3d across(const Vector3d& direction) {
    const Vector3d other = std::abs(direction.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
    return direction.cross(other).normalized();
}

/// Part of a circle with two perpendicular radii u, v.
void add_circle(LineBatch& lines, const Vector3d& centre, const Vector3d& u, const Vector3d& v,
                double from_rad, double to_rad, const LineStyle& style) {
    const int steps =
        std::max(2, static_cast<int>(std::ceil(48.0 * std::abs(to_rad - from_rad) / kTurn)));
    std::vector<Vector3d> points;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from_rad + (to_rad - from_rad) * i / steps;
        points.push_back(centre + std::cos(angle) * u + std::sin(angle) * v);
    }
    lines.polyline(points, style);
}

}  // namespace

void add_box(LineBatch& lines, const Box& box, const Pose& T_world_box, const LineStyle& style) {
    if (!box.valid()) return;
    const auto corners = box.corners();  // bit i of the index: max in coordinate i
    for (unsigned i = 0; i < 8; ++i) {
        for (unsigned bit = 1; bit < 8; bit <<= 1U) {
            if ((i & bit) == 0) {
                lines.segment(T_world_box * corners[i], T_world_box * corners[i | bit], style);
            }
        }
    }
}

void add_axis(LineBatch& lines, const Axis& axis, double from_m, double to_m,
              const LineStyle& style) {
    lines.segment(axis.point_m + from_m * axis.direction, axis.point_m + to_m * axis.direction,
                  style);
}

void add_arc(LineBatch& lines, const Axis& axis, const Vector3d& start_m, double from_rad,
             double to_rad, const LineStyle& style) {
    const Vector3d centre = axis.nearest_to(start_m);
    const Vector3d u = start_m - centre;
    add_circle(lines, centre, u, axis.direction.cross(u), from_rad, to_rad, style);
}

void add_frustum(LineBatch& lines, const RectifiedRig& rig, double depth_m,
                 const LineStyle& style) {
    if (!(rig.f_px > 0.0)) return;
    const auto at = [&](double u, double v) {
        return Vector3d((u - rig.cx_left_px) * depth_m / rig.f_px,
                        (v - rig.cy_px) * depth_m / rig.f_px, depth_m);
    };
    const std::array<Vector3d, 5> frame{at(0, 0), at(rig.image.width, 0),
                                        at(rig.image.width, rig.image.height),
                                        at(0, rig.image.height), at(0, 0)};
    lines.polyline(frame, style);
    for (std::size_t i = 0; i < 4; ++i) lines.segment(Vector3d::Zero(), frame[i], style);
}

void add_capsule(LineBatch& lines, const Vector3d& a_m, const Vector3d& b_m, double radius_m,
                 const Vector3d& eye_m, const LineStyle& style) {
    const double length = (b_m - a_m).norm();
    const Vector3d along = length > 1e-9 ? Vector3d((b_m - a_m) / length) : Vector3d::UnitZ();
    const Vector3d to_eye = eye_m - 0.5 * (a_m + b_m);
    const Vector3d cross = along.cross(to_eye);
    const Vector3d side =
        (cross.norm() > 1e-9 * to_eye.norm() ? Vector3d(cross.normalized()) : across(along)) *
        radius_m;
    lines.segment(a_m + side, b_m + side, style);
    lines.segment(a_m - side, b_m - side, style);
    const Vector3d up = along.cross(side);
    add_circle(lines, a_m, side, up, 0.0, kTurn, style);
    add_circle(lines, b_m, side, up, 0.0, kTurn, style);
    // The round ends beyond the circles, in the plane of the sides.
    add_circle(lines, b_m, side, along * radius_m, 0.0, 0.5 * kTurn, style);
    add_circle(lines, a_m, side, -along * radius_m, 0.0, 0.5 * kTurn, style);
}

void add_grid(LineBatch& lines, const Vector3d& centre_m, const Vector3d& normal, double half_m,
              double cell_m, const LineStyle& style) {
    if (!(cell_m > 0.0) || half_m / cell_m > 500.0) return;
    const Vector3d u = across(normal.normalized());
    const Vector3d v = normal.normalized().cross(u);
    const int cells = static_cast<int>(half_m / cell_m);
    const double reach = cells * cell_m;
    for (int i = -cells; i <= cells; ++i) {
        const double at = i * cell_m;
        lines.segment(centre_m + at * u - reach * v, centre_m + at * u + reach * v, style);
        lines.segment(centre_m + at * v - reach * u, centre_m + at * v + reach * u, style);
    }
}

void add_cross(LineBatch& lines, const Vector3d& at_m, double half_m, const LineStyle& style) {
    for (int i = 0; i < 3; ++i) {
        lines.segment(at_m - half_m * Vector3d::Unit(i), at_m + half_m * Vector3d::Unit(i), style);
    }
}

}  // namespace gripscan::ui
