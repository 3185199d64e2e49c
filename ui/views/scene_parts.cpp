#include "ui/views/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "ui/views/recognition_text.h"
#include "ui/views/scene_words.h"

namespace gripscan::ui {
namespace {

constexpr std::uint64_t kTemplateId = std::uint64_t{1} << 40U;
constexpr std::uint64_t kFoundId = std::uint64_t{1} << 41U;
constexpr std::uint64_t kGripperId = std::uint64_t{1} << 42U;

/// Check too: such a view is merged.
bool places_the_view(const TurnStep& step) {
    return step.T.has_value() && step.verdict != Verdict::kReject;
}

const JudgedStep* step_between(const std::vector<JudgedStep>& table, int from, int to) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const JudgedStep& step) {
        return step.row.from == from && step.row.to == to;
    });
    return found == table.end() ? nullptr : &*found;
}

const ShownCapture* shown_of(const Snapshot& snapshot, int index) {
    const auto found =
        std::find_if(snapshot.captures.begin(), snapshot.captures.end(),
                     [&](const ShownCapture& capture) { return capture.index == index; });
    return found == snapshot.captures.end() || !found->cloud || found->cloud->empty() ? nullptr
                                                                                      : &*found;
}

/// The step of Table 1 that is looked at; null: there is none.
const JudgedStep* selected_step(const Snapshot& snapshot, const std::vector<JudgedStep>& table) {
    if (table.empty()) return nullptr;
    return snapshot.follows_last                  ? &table.back()
           : snapshot.selected_row < table.size() ? &table[snapshot.selected_row]
                                                  : nullptr;
}

std::string why_no_pair(const Snapshot& snapshot, const JudgedStep* step) {
    if (step == nullptr) return "no step has been judged yet";
    if (shown_of(snapshot, step->row.from) == nullptr ||
        shown_of(snapshot, step->row.to) == nullptr) {
        return fmt::format("the clouds of step {} are not here", step->row.index);
    }
    return {};
}

/// A rejected step and one that was chosen show their clouds without being asked.
bool pair_wanted(const Snapshot& snapshot, const SceneWish& wish, const JudgedStep* step) {
    if (snapshot.page == Page::kTemplate || !why_no_pair(snapshot, step).empty()) return false;
    return wish.pair.value_or(!snapshot.follows_last || step->row.verdict == Verdict::kReject);
}

SceneCloud cloud_of(const ShownCapture& capture, int step) {
    SceneCloud cloud;
    cloud.id = static_cast<std::uint64_t>(capture.index) + 1;
    cloud.generation = (capture.residual_generation << 32U) + capture.generation;
    cloud.cloud = capture.cloud;
    cloud.residual_m = capture.residual_m;
    cloud.step = step;
    return cloud;
}

/// The used captures that are here, each where it belongs; those without a place are hidden.
void add_views(const Snapshot& snapshot, SceneParts& parts) {
    const TurnData& data = snapshot.procedure->data;
    const auto poses = capture_poses(snapshot);
    int step = 0;
    for (const std::size_t at : data.used()) {
        const ShownCapture* capture = shown_of(snapshot, data.captures[at].index);
        const bool placed = poses[at].has_value();
        parts.not_placed += placed ? 0 : 1;
        if (capture != nullptr) {
            SceneCloud cloud = cloud_of(*capture, step);
            cloud.visible = placed;
            if (placed) cloud.T_first_cloud = *poses[at];
            parts.clouds.push_back(std::move(cloud));
        }
        ++step;
    }
}

/// Of an object's turn: the gripper of the latest view, where it stands.
void add_gripper(const Snapshot& snapshot, SceneParts& parts) {
    const auto last = std::find_if(parts.clouds.rbegin(), parts.clouds.rend(),
                                   [](const SceneCloud& cloud) { return cloud.visible; });
    if (last == parts.clouds.rend()) return;
    const ShownCapture* capture = shown_of(snapshot, static_cast<int>(last->id) - 1);
    if (capture == nullptr || !capture->split) return;
    parts.split = capture->split;
    parts.T_first_split = last->T_first_cloud;
    if (capture->split->gripper_part.empty()) return;
    SceneCloud gripper;
    gripper.id = kGripperId + last->id;
    gripper.generation = last->generation;
    gripper.cloud = {capture->split, &capture->split->gripper_part};
    gripper.T_first_cloud = last->T_first_cloud;
    gripper.role = CloudRole::kHolder;
    gripper.colour = &Theme::gripper;
    parts.clouds.push_back(std::move(gripper));
}

/// The clouds of the step stand in the camera frame of the first of them.
void make_pair(const TurnStep& step, const std::optional<Axis>& axis, PairPose pose,
               SceneParts& parts) {
    parts.kind = SceneKind::kPair;
    parts.pair_from = step.from;
    parts.pair_to = step.to;
    const auto robot_rad = step.robot_rad ? step.robot_rad : step.commanded_rad;
    if (!step.T) parts.why_no_aligned = "the registration found no pose";
    if (!axis) {
        parts.why_no_robot = "the axis is not known yet";
    } else if (!robot_rad) {
        parts.why_no_robot = "the robot's angle is not known";
    }
    Pose T_from_to = Pose::Identity();
    if (pose == PairPose::kAligned && step.T) T_from_to = step.T->inverse();
    if (pose == PairPose::kRobot && parts.why_no_robot.empty()) {
        T_from_to = turn_about(*axis, -*robot_rad);
    }
    for (SceneCloud& cloud : parts.clouds) {
        const auto index = static_cast<int>(cloud.id) - 1;
        cloud.visible = index == step.from || index == step.to;
        if (!cloud.visible) continue;
        cloud.role = index == step.from ? CloudRole::kTarget : CloudRole::kSource;
        cloud.T_first_cloud = index == step.from ? Pose::Identity() : T_from_to;
    }
}

void make_template(const Snapshot& snapshot, SceneParts& parts) {
    parts.kind = SceneKind::kTemplate;
    for (SceneCloud& cloud : parts.clouds) cloud.visible = false;
    SceneCloud merged;
    merged.id = kTemplateId;
    merged.cloud = {snapshot.solved, &snapshot.solved->report.merged};
    // As long as the solution is held its address names it.
    merged.generation = reinterpret_cast<std::uintptr_t>(snapshot.solved.get());
    merged.role = CloudRole::kTemplate;
    parts.clouds.push_back(std::move(merged));
}

/// A recognised view: the templates' points in their colours, the rest in grey.
SceneParts found_scene(const Snapshot& snapshot) {
    SceneParts parts;
    if (!snapshot.recognition) return parts;
    const ShownRecognition& shown = *snapshot.recognition;
    parts.kind = SceneKind::kFound;
    const auto add = [&](const std::shared_ptr<const Cloud>& cloud, CloudRole role) {
        if (!cloud || cloud->empty()) return;
        SceneCloud part;
        part.id = kFoundId + parts.clouds.size();
        part.generation = shown.generation;
        part.cloud = cloud;
        part.role = role;
        parts.clouds.push_back(std::move(part));
    };
    add(shown.rest, CloudRole::kScene);
    for (std::size_t i = 0; i < shown.found.size(); ++i) {
        const std::size_t before = parts.clouds.size();
        add(shown.found[i].matched, CloudRole::kFound);
        if (parts.clouds.size() > before) parts.clouds.back().colour = colour_of_found(shown, i);
    }
    return parts;
}

double angle_of(const TurnStep& step) {
    return step.robot_rad.value_or(step.commanded_rad.value_or(step.icp_rad.value_or(0.0)));
}

/// The arc up to the step that is shown, or to the last trusted one.
void fill_turn(const ProcedureState& state, const std::vector<JudgedStep>& table,
               const JudgedStep* pair, SceneParts& parts) {
    for (const JudgedStep& step : table) {
        if (&step == pair) {
            parts.turn.robot_rad = parts.turn.turned_rad + angle_of(step.row);
            if (step.row.icp_rad) parts.turn.icp_rad = parts.turn.turned_rad + *step.row.icp_rad;
            break;
        }
        if (!places_the_view(step.row)) break;
        parts.turn.turned_rad += angle_of(step.row);
        ++parts.steps_done;
    }
    const double step_rad = state.data.step_rad > 0.0 ? state.data.step_rad : state.plan.step_rad;
    const double left_rad = state.plan.total_rad - parts.turn.turned_rad;
    const int left = step_rad > 0.0 ? static_cast<int>(std::ceil(left_rad / step_rad - 0.01)) : 0;
    parts.steps_total = parts.steps_done + std::max(0, left);
    if (pair == nullptr && left > 0) parts.turn.next_rad = parts.turn.turned_rad + step_rad;
}

}  // namespace

std::vector<std::optional<Pose>> capture_poses(const Snapshot& snapshot) {
    if (snapshot.procedure == nullptr) return {};
    const TurnData& data = snapshot.procedure->data;
    const auto used = data.used();
    std::vector<std::optional<Pose>> poses(data.captures.size());
    if (snapshot.solved && snapshot.solved->report.poses.size() == poses.size()) {
        for (const std::size_t at : used) poses[at] = snapshot.solved->report.poses[at];
        return poses;
    }
    if (used.empty()) return poses;
    const auto table = table_of(*snapshot.procedure);
    poses[used.front()] = Pose::Identity();
    for (std::size_t i = 1; i < used.size(); ++i) {
        const JudgedStep* step =
            step_between(table, data.captures[used[i - 1]].index, data.captures[used[i]].index);
        if (step == nullptr || !places_the_view(step->row)) break;
        poses[used[i]] = *poses[used[i - 1]] * step->row.T->inverse();
    }
    return poses;
}

std::string why_no_pair(const Snapshot& snapshot) {
    if (snapshot.procedure == nullptr) return "no session is open";
    if (snapshot.page == Page::kTemplate) return "the template is shown";
    if (snapshot.page == Page::kRecognise) return "a recognised view is shown";
    const auto table = table_of(*snapshot.procedure);
    return why_no_pair(snapshot, selected_step(snapshot, table));
}

SceneParts scene_parts(const Snapshot& snapshot, const SceneWish& wish) {
    if (snapshot.page == Page::kRecognise) return found_scene(snapshot);
    SceneParts parts;
    if (snapshot.procedure == nullptr) return parts;
    const auto table = table_of(*snapshot.procedure);
    const JudgedStep* selected = selected_step(snapshot, table);
    const bool pair = pair_wanted(snapshot, wish, selected);
    add_views(snapshot, parts);
    fill_turn(*snapshot.procedure, table, pair ? selected : nullptr, parts);
    if (pair) {
        make_pair(selected->row, snapshot.cell.axis, wish.pair_pose, parts);
    } else if (snapshot.page == Page::kTemplate && snapshot.solved &&
               !snapshot.solved->report.merged.empty()) {
        make_template(snapshot, parts);
    } else {
        const bool any = std::any_of(parts.clouds.begin(), parts.clouds.end(),
                                     [](const SceneCloud& cloud) { return cloud.visible; });
        parts.kind = any ? SceneKind::kGrowing : SceneKind::kEmpty;
        add_gripper(snapshot, parts);
    }
    return parts;
}

std::size_t visible_points(const SceneParts& parts) {
    std::size_t sum = 0;
    for (const SceneCloud& cloud : parts.clouds) sum += cloud.visible ? cloud.cloud->size() : 0;
    return sum;
}

}  // namespace gripscan::ui
