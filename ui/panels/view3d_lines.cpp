#include "ui/panels/view3d_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "core/base/units.h"
#include "core/robot/kinematics.h"
#include "ui/panels/view3d_turn.h"
#include "ui/render/primitives.h"
#include "ui/render/silhouette.h"
#include "ui/theme/shown_number.h"
#include "ui/views/cell_view.h"
#include "ui/views/recognition_text.h"

namespace gripscan::ui {
namespace {

/// The room that the lines are laid out in: the registration area, else around the clouds.
std::optional<Box> room_of(const LineInput& input) {
    if (input.parts.kind == SceneKind::kTemplate && input.around.valid()) return input.around;
    if (input.snapshot.cell.region) return input.snapshot.cell.region;
    if (input.around.valid()) return input.around;
    return std::nullopt;
}

void add_floor(const LineInput& input, const Box& room, LineBatch& lines) {
    constexpr double kCell_m = 0.05;
    Eigen::Vector3d centre = 0.5 * (room.min_m + room.max_m);
    centre.y() = room.max_m.y();  // y points down
    const Colour colour = input.theme.dark ? Colour{255, 255, 255}.with_alpha(0.055)
                                           : Colour{0, 0, 0}.with_alpha(0.10);
    add_grid(lines, centre, Eigen::Vector3d::UnitY(), 0.5, kCell_m,
             {colour, 1.0F, {}, HiddenStyle::kGone});
}

/// The corner of a box that lies lowest at the left of the view.
Eigen::Vector3d lower_left_corner(const Box& box, const LineInput& input) {
    Eigen::Vector3d best = box.min_m;
    double least = 1e300;
    for (const Eigen::Vector3d& corner : box.corners()) {
        const auto px = project(input.camera, input.viewport, corner);
        if (!px) continue;
        const double score = 2.0 * px->x() - px->y();
        if (score < least) {
            least = score;
            best = corner;
        }
    }
    return best;
}

void add_region(const LineInput& input, SceneLines& out) {
    const auto& region = input.snapshot.cell.region;
    if (!region || input.parts.kind == SceneKind::kTemplate ||
        input.parts.kind == SceneKind::kFound) {
        return;
    }
    add_box(out.lines, *region, Pose::Identity(),
            {input.theme.text_third, 1.0F, {}, HiddenStyle::kFaint});
    out.labels.push_back({lower_left_corner(*region, input),
                          "registration area",
                          {},
                          input.theme.text_second,
                          -8.0,
                          0.0});
}

/// Its lines, and its sizes beside them.
void add_edited_box(const LineInput& input, SceneLines& out) {
    const bool region = input.parts.kind == SceneKind::kEmpty;
    if (region && !input.edits_region && !input.snapshot.cell.wished_region) return;
    const auto box = editable_box(input.snapshot, input.parts, input.around);
    if (!box) return;
    add_box(out.lines, *box, Pose::Identity(),
            {input.theme.accent, 1.6F, {}, HiddenStyle::kDotted});
    const Eigen::Vector3d size = kMmPerM * (box->max_m - box->min_m);
    const Eigen::Vector3d low = lower_left_corner(*box, input);
    constexpr std::array kNames{"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3d middle = low;
        middle(axis) = 0.5 * (box->min_m(axis) + box->max_m(axis));
        out.labels.push_back({middle,
                              fmt::format("{} {} mm", kNames[static_cast<std::size_t>(axis)],
                                          shown_number(size(axis), 1)),
                              {},
                              input.theme.accent_text,
                              -8.0,
                              0.0});
    }
}

void add_camera(const LineInput& input, LineBatch& lines) {
    if (!input.snapshot.cell.rig) return;
    constexpr double kBody_m = 0.06;
    const LineStyle style{input.theme.text_third, 1.2F, {}, HiddenStyle::kFaint};
    add_frustum(lines, *input.snapshot.cell.rig, kBody_m, style);
    const Eigen::Vector3d right(input.snapshot.cell.rig->baseline_m, 0.0, 0.0);
    add_cross(lines, right, 0.008, style);
    lines.segment(Eigen::Vector3d::Zero(), right, style);
    if (const auto room = room_of(input)) {
        add_frustum(
            lines, *input.snapshot.cell.rig, room->max_m.z(),
            {input.theme.text_third.with_alpha(0.7), 1.0F, {2, 5, 0, 0}, HiddenStyle::kGone});
    }
}

void add_arm(const LineInput& input, LineBatch& lines) {
    if (!input.snapshot.cell.T_robot_camera || input.snapshot.procedure == nullptr ||
        !input.snapshot.procedure->reading) {
        return;
    }
    const Pose T_camera_robot = input.snapshot.cell.T_robot_camera->inverse();
    const auto links = link_poses(input.snapshot.procedure->reading->joints_rad);
    constexpr std::array kRadius_m{0.09, 0.075, 0.065, 0.055, 0.05, 0.035};
    constexpr double kShortest_m = 0.01;
    const Eigen::Vector3d eye = input.camera.eye_m();
    for (std::size_t i = 0; i + 1 < links.size(); ++i) {
        const Eigen::Vector3d a = T_camera_robot * links[i].translation();
        const Eigen::Vector3d b = T_camera_robot * links[i + 1].translation();
        if ((b - a).norm() < kShortest_m) continue;
        add_capsule(lines, a, b, kRadius_m[i], eye,
                    {input.theme.text_third, 1.2F, {}, HiddenStyle::kFaint});
    }
    const Pose T_camera_tool =
        T_camera_robot * tool_pose(input.snapshot.procedure->reading->joints_rad);
    add_arc(lines, {T_camera_tool.translation(), T_camera_tool.linear().col(2)},
            T_camera_tool * Eigen::Vector3d(0.0315, 0.0, 0.0), 0.0, 2.0 * std::numbers::pi,
            {input.theme.text_third, 1.2F});
}

/// The last view turned on by the next step, as a dashed outline at the pivot's depth.
void add_ghost(const LineInput& input, LineBatch& lines) {
    const auto& axis = input.snapshot.cell.axis;
    if (!axis || input.parts.kind != SceneKind::kGrowing || !input.parts.turn.next_rad) return;
    const auto last = std::find_if(input.parts.clouds.rbegin(), input.parts.clouds.rend(),
                                   [](const SceneCloud& cloud) { return cloud.visible; });
    const double angle_rad = *input.parts.turn.next_rad - input.parts.turn.turned_rad;
    const Pose T = turn_about(*axis, angle_rad) * last->T_first_cloud;
    const LineStyle style{input.theme.accent_text, 1.3F, {5, 4, 0, 0}, HiddenStyle::kSame};
    SilhouetteSettings settings;
    settings.cell_px *= input.px;
    settings.least_px *= input.px;
    for (const auto& outline :
         silhouette(last->cloud->points, T, input.camera, input.viewport, settings)) {
        std::vector<Eigen::Vector3d> points;
        for (const Eigen::Vector2d& px : outline) {
            points.push_back(unproject(input.camera, input.viewport, px, input.camera.distance_m));
        }
        lines.polyline(points, style);
    }
}

/// Of an object's turn: gripper and object in their cuboids.
void add_split(const LineInput& input, SceneLines& out) {
    if (!input.parts.split) return;
    const auto add = [&](const OrientedCuboid& cuboid, const Colour& colour, const char* name) {
        const Pose T = input.parts.T_first_split * cuboid.T_frame_cuboid;
        add_box(out.lines, {-cuboid.half_m, cuboid.half_m}, T,
                {colour, 1.6F, {}, HiddenStyle::kFaint});
        out.labels.push_back({T * cuboid.half_m, name, {}, colour, 8.0, 0.0});
    };
    add(input.parts.split->gripper_cuboid, input.theme.gripper, "gripper, subtracted");
    if (input.parts.split->object_cuboid) {
        add(*input.parts.split->object_cuboid, input.theme.object, "object");
    }
}

/// Cuboids and frames of the templates that were found.
void add_found(const LineInput& input, SceneLines& out) {
    if (input.parts.kind != SceneKind::kFound) return;
    const ShownRecognition& shown = *input.snapshot.recognition;
    const std::array colours{input.theme.axis_x, input.theme.axis_y, input.theme.axis_z};
    for (std::size_t i = 0; i < shown.found.size(); ++i) {
        const FoundTemplate& found = shown.found[i];
        const Pose& T = found.T_camera_template;
        const Colour colour = input.theme.*colour_of_found(shown, i);
        add_box(out.lines, found.box, T, {colour, 1.6F, {}, HiddenStyle::kFaint});
        const Eigen::Vector3d middle = 0.5 * (found.box.min_m + found.box.max_m);
        const double length_m = 0.35 * (found.box.max_m - found.box.min_m).norm();
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d end = middle + length_m * Eigen::Vector3d::Unit(k);
            out.lines.segment(T * middle, T * end,
                              {colours[static_cast<std::size_t>(k)], 2.4F, {}, HiddenStyle::kSame});
        }
        out.labels.push_back({T * found.box.max_m, found.name, {}, colour, 8.0, 0.0});
    }
}

}  // namespace

std::string why_no_region_box(const Snapshot& snapshot, const SceneParts& parts) {
    const std::string fixed = why_region_is_fixed(snapshot);
    if (!fixed.empty()) return fixed;
    const bool there = parts.kind == SceneKind::kEmpty && snapshot.page != Page::kRecognise &&
                       snapshot.page != Page::kTemplate;
    return there ? "" : "The registration area is edited on the Procedure page.";
}

std::optional<Box> editable_box(const Snapshot& snapshot, const SceneParts& parts,
                                const Box& around) {
    if (why_no_region_box(snapshot, parts).empty()) return edited_region(snapshot.cell);
    if (parts.kind != SceneKind::kTemplate) return std::nullopt;
    if (snapshot.filter.crop) return snapshot.filter.crop;
    return around.valid() ? std::optional(around) : std::nullopt;
}

SceneLines scene_lines(const LineInput& input) {
    SceneLines out;
    if (const auto room = room_of(input); room && input.show_cell) {
        add_floor(input, *room, out.lines);
        add_turn(input, *room, out);
    }
    if (input.show_cell) {
        add_region(input, out);
        add_camera(input, out.lines);
        add_arm(input, out.lines);
        add_ghost(input, out.lines);
    }
    add_edited_box(input, out);
    add_found(input, out);
    add_split(input, out);
    if (input.pivot_m) {
        const double half_m = 10.0 * input.px / input.camera.px_per_m(input.viewport);
        add_cross(out.lines, *input.pivot_m, half_m,
                  {input.theme.accent_text, 1.2F, {}, HiddenStyle::kSame});
    }
    return out;
}

}  // namespace gripscan::ui
