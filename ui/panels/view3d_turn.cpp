#include "ui/panels/view3d_turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "core/base/units.h"
#include "ui/render/primitives.h"
#include "ui/theme/shown_number.h"

namespace gripscan::ui {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Where the room begins and ends along the axis, and how far it reaches from it.
struct Reach {
    double from_m = 1e300;
    double to_m = -1e300;
    double radius_m = 0.0;
};

Reach reach_of(const Box& room, const Axis& axis) {
    Reach reach;
    for (const Eigen::Vector3d& corner : room.corners()) {
        const double s = axis.direction.dot(corner - axis.point_m);
        reach.from_m = std::min(reach.from_m, s);
        reach.to_m = std::max(reach.to_m, s);
        reach.radius_m = std::max(reach.radius_m, axis.distance_m(corner));
    }
    return reach;
}

/// The circle that the turn is shown on.
struct Dial {
    Axis axis;
    Eigen::Vector3d start_m;  ///< at angle 0

    [[nodiscard]] Eigen::Vector3d at(double angle_rad, double scale = 1.0) const {
        const Eigen::Vector3d centre = axis.nearest_to(start_m);
        return centre + Eigen::AngleAxisd(angle_rad, axis.direction) * (scale * (start_m - centre));
    }
};

/// At the end of the room that is nearer to the eye's left, zero at the top.
Dial dial_of(const Axis& axis, const Reach& reach) {
    const Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
    Eigen::Vector3d radial = up - axis.direction.dot(up) * axis.direction;
    if (radial.norm() < 0.1) radial = axis.direction.cross(Eigen::Vector3d::UnitX());
    constexpr double kPartOfRoom = 0.62;
    const Eigen::Vector3d centre =
        axis.point_m + (reach.from_m + 0.12 * (reach.to_m - reach.from_m)) * axis.direction;
    return {axis, centre + kPartOfRoom * reach.radius_m * radial.normalized()};
}

std::string degrees(double rad, int decimals) {
    return shown_number(deg_from_rad(rad), decimals) + "°";
}

void add_axis_line(const LineInput& input, const Axis& axis, const Reach& reach, SceneLines& out) {
    const double length_m = reach.to_m - reach.from_m;
    const double from_m = reach.from_m - 0.12 * length_m;
    add_axis(out.lines, axis, from_m, reach.to_m + 0.4 * length_m,
             {input.theme.axis, 1.6F, {14, 4, 3, 4}, HiddenStyle::kFaint});
    if (input.parts.kind == SceneKind::kTemplate) return;
    const auto& sd_rad = input.snapshot.cell.axis_sd_rad;
    out.labels.push_back({axis.point_m + from_m * axis.direction, "J6 axis",
                          sd_rad ? "sd " + degrees(*sd_rad, 2) : std::string(), input.theme.axis,
                          -8.0, 14.0});
}

void add_ticks(const LineInput& input, const Dial& dial, SceneLines& out) {
    const int steps = input.parts.steps_done;
    for (int i = 0; i <= steps && steps > 0; ++i) {
        const double angle = input.parts.turn.turned_rad * i / steps;
        out.lines.segment(dial.at(angle, 0.97), dial.at(angle, 1.03), {input.theme.axis, 1.0F});
    }
}

void add_next(const LineInput& input, const Dial& dial, SceneLines& out) {
    const SceneTurn& turn = input.parts.turn;
    if (!turn.next_rad) return;
    add_arc(out.lines, dial.axis, dial.start_m, turn.turned_rad, *turn.next_rad,
            {input.theme.accent_text, 3.0F});
    out.labels.push_back({dial.at(*turn.next_rad),
                          "next " + degrees(*turn.next_rad, 0),
                          {},
                          input.theme.accent_text,
                          -8.0,
                          0.0});
}

/// Two arcs of the step: what the robot says inside, what the registration says outside.
void add_step(const LineInput& input, const Dial& dial, SceneLines& out) {
    const SceneTurn& turn = input.parts.turn;
    if (!turn.robot_rad) return;
    add_arc(out.lines, dial.axis, dial.start_m, turn.turned_rad, *turn.robot_rad,
            {input.theme.accent_text, 3.0F});
    out.labels.push_back({dial.at(*turn.robot_rad),
                          "robot " + degrees(*turn.robot_rad, 1),
                          {},
                          input.theme.accent_text,
                          -8.0,
                          6.0});
    if (!turn.icp_rad) return;
    constexpr double kOutside = 1.06;
    add_arc(out.lines, dial.axis, dial.at(0.0, kOutside), turn.turned_rad, *turn.icp_rad,
            {input.theme.source, 3.0F});
    out.labels.push_back({dial.at(*turn.icp_rad, kOutside),
                          "ICP " + degrees(*turn.icp_rad, 1),
                          {},
                          input.theme.source,
                          -8.0,
                          -8.0});
}

}  // namespace

void add_turn(const LineInput& input, const Box& room, SceneLines& out) {
    const auto& axis = input.snapshot.cell.axis;
    if (!axis) return;
    const Reach reach = reach_of(room, *axis);
    add_axis_line(input, *axis, reach, out);
    if (input.parts.kind != SceneKind::kGrowing && input.parts.kind != SceneKind::kPair) return;
    const Dial dial = dial_of(*axis, reach);
    add_arc(out.lines, *axis, dial.start_m, 0.0, kTurn, {input.theme.text_third, 0.7F});
    add_arc(out.lines, *axis, dial.start_m, 0.0, input.parts.turn.turned_rad,
            {input.theme.axis, 2.4F});
    add_ticks(input, dial, out);
    add_next(input, dial, out);
    add_step(input, dial, out);
}

}  // namespace gripscan::ui
