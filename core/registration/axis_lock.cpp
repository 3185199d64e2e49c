#include "core/registration/axis_lock.h"

#include <algorithm>
#include <vector>

#include "core/registration/align_surfaces.h"
#include "core/registration/joint_solution.h"
#include "core/registration/revolution_axis.h"
#include "core/registration/turn_poses.h"

namespace gripscan {
namespace {

std::vector<std::size_t> usable_views(std::span<const PreparedView* const> views) {
    std::vector<std::size_t> usable;
    for (std::size_t k = 0; k < views.size(); ++k) {
        if (views[k]->usable()) usable.push_back(k);
    }
    return usable;
}

std::optional<AxisEstimate> axis_of_revolution(std::span<const PreparedView* const> views,
                                               const std::vector<std::size_t>& usable,
                                               const TurnSettings& settings) {
    std::vector<const Surface*> surfaces;
    for (const std::size_t k : usable) surfaces.push_back(&views[k]->surface);
    std::optional<Axis> axis = revolution_axis(surfaces);
    if (!axis) return std::nullopt;
    if (settings.axis_hint && axis->direction.dot(*settings.axis_hint) < 0.0) {
        axis->direction = -axis->direction;
    }
    return AxisEstimate{*axis, 0.0, 0.0};
}

}  // namespace

bool any_locked(std::span<const CaptureFacts> facts) {
    // The first capture has no step that leads to it.
    return std::any_of(facts.begin() + std::min<std::ptrdiff_t>(1, std::ssize(facts)), facts.end(),
                       [](const CaptureFacts& f) { return f.mode == TurnMode::kAxisLocked; });
}

Result<std::optional<AxisEstimate>> axis_for_lock(std::span<const CaptureFacts> facts,
                                                  std::span<const PreparedView* const> views,
                                                  const std::optional<AxisEstimate>& free,
                                                  const TurnSettings& settings,
                                                  const Progress& progress,
                                                  const ForEach& for_each) {
    const std::vector<std::size_t> usable = usable_views(views);
    std::optional<AxisEstimate> start = free ? free : settings.known_axis;
    if (!start) start = axis_of_revolution(views, usable, settings);
    if (!start || usable.size() < 2) return start;
    const auto solution = solve_jointly(joint_views(facts, views, usable, {}), start->axis,
                                        joint_settings(facts, views), progress, for_each);
    if (!solution) return forward_error(solution.error());
    return std::optional<AxisEstimate>(solution->axis);
}

Alignment locked_alignment(const PreparedView& from, const PreparedView& to,
                           const std::optional<AxisEstimate>& axis, std::optional<double> angle_rad,
                           const AlignSettings& settings) {
    Alignment none;
    if (!axis) {
        none.sentence =
            "locked to the axis, but no axis is known: let one step run free or warm up";
        return none;
    }
    if (!angle_rad) {
        none.sentence = "locked to the axis, but neither the robot nor a command says by how much";
        return none;
    }
    Alignment locked =
        alignment_at(from.surface, to.surface, turn_about(axis->axis, *angle_rad), settings);
    locked.cause = Cause::kNone;
    locked.starts_agree = true;
    return locked;
}

}  // namespace gripscan
