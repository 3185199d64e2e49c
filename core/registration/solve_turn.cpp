#include "core/registration/solve_turn.h"

#include <algorithm>
#include <atomic>

#include "core/registration/align_held.h"
#include "core/registration/align_surfaces.h"
#include "core/registration/axis_lock.h"
#include "core/registration/common_cause.h"
#include "core/registration/diagnosed_step.h"
#include "core/registration/merge.h"
#include "core/registration/turn_poses.h"
#include "core/registration/turn_rows.h"
#include "core/registration/view_chain.h"

namespace gripscan {
namespace {

/// Bridges over at most this many contradicted views.
constexpr std::size_t kLongestGap = 3;

/// What all parts of the solution need.
struct Turn {
    const PreparedTurn& given;
    const TurnSettings& settings;
    const Progress& progress;
    const ForEach& for_each;
    std::vector<std::optional<ImageFault>> faults;  ///< of each view's images

    [[nodiscard]] std::size_t size() const { return given.views.size(); }
    [[nodiscard]] StepEnd end(std::size_t k) const {
        return {given.facts[k], *given.views[k], faults[k]};
    }
};

Status check_usable(const PreparedTurn& turn) {
    const auto usable = std::count_if(turn.views.begin(), turn.views.end(),
                                      [](const PreparedView* view) { return view->usable(); });
    if (usable >= 2) return {};
    const std::string& first = turn.views.front()->flaw;
    return input_error("{} of {} captures have enough points; capture {}: {}", usable,
                       turn.views.size(), turn.facts.front().index,
                       first.empty() ? turn.views.back()->flaw : first);
}

/// Middle of what all views show: the part turns in place.
Eigen::Vector3d centre_of(std::span<const PreparedView* const> views) {
    Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
    double count = 0.0;
    for (const PreparedView* view : views) {
        if (view->surface.size() == 0) continue;
        sum_m += view->surface.centre_m;
        count += 1.0;
    }
    return sum_m / count;
}

/// The common axis: that of the free steps; where steps are locked, what all views say together.
Status find_axis(const Turn& turn, TurnReport& report) {
    std::vector<TurnStep> rows;
    for (std::size_t i = 0; i + 1 < turn.size(); ++i) {
        rows.push_back(
            measured_step(turn.end(i), turn.end(i + 1), turn.given.steps[i], turn.settings));
    }
    const StepsAxis axis =
        axis_from_steps(rows, turn.settings.axis_hint, centre_of(turn.given.views));
    report.axis = axis.estimate;
    report.sign_source = axis.sign_source;
    if (turn.settings.method != TurnMethod::kTurn || !any_locked(turn.given.facts)) return {};
    auto locked = axis_for_lock(turn.given.facts, turn.given.views, axis.estimate, turn.settings,
                                turn.progress, turn.for_each);
    if (!locked) return forward_error(std::move(locked.error()));
    report.axis = *locked;
    return {};
}

/// Table 1, judged.
void fill_rows(const Turn& turn, TurnReport& report) {
    std::vector<DiagnosedStep> judged(turn.size() - 1);
    turn.for_each(judged.size(), [&](std::size_t i) {
        if (turn.progress.cancelled()) return;
        judged[i] = diagnosed_step(turn.end(i), turn.end(i + 1), turn.given.steps[i], report.axis,
                                   turn.settings);
        judged[i].step.index = static_cast<int>(i) + 1;
    });
    for (DiagnosedStep& one : judged) {
        report.steps.push_back(std::move(one.step));
        report.evidence.push_back(std::move(one.evidence));
    }
}

/// Do two views that are not neighbours fit together and to the robot?
bool bridge_holds(const Turn& turn, const std::optional<AxisEstimate>& axis, std::size_t from,
                  std::size_t to) {
    if (!axis || turn.progress.cancelled()) return false;
    const auto alignment =
        align_views(turn.given.facts[from], *turn.given.views[from], turn.given.facts[to],
                    *turn.given.views[to], turn.settings, turn.progress, turn.for_each);
    if (!alignment) return false;
    StepFinding finding{*alignment, std::nullopt};
    if (turn.given.camera_shift) finding.camera_shift = turn.given.camera_shift(from, to);
    const TurnStep step =
        diagnosed_step(turn.end(from), turn.end(to), finding, axis, turn.settings).step;
    if (!step.T || !reported_rad(step)) return false;
    return step.verdict == Verdict::kAccept ||
           (step.mode == TurnMode::kAxisLocked && step.verdict == Verdict::kCheck);
}

ViewChain link(const Turn& turn, const TurnReport& report) {
    std::vector<bool> trusted;
    for (const TurnStep& step : report.steps) trusted.push_back(step.verdict != Verdict::kReject);
    return link_views(trusted, kLongestGap, [&](std::size_t from, std::size_t to) {
        return bridge_holds(turn, report.axis, from, to);
    });
}

/// Steps into and out of a view that was bridged over: that capture is what does not fit.
void name_contradicted(const Turn& turn, const ViewChain& chain, TurnReport& report) {
    for (const std::size_t v : chain.bridged) {
        const int index = turn.given.facts[v].index;
        for (std::size_t i = 0; i < report.steps.size(); ++i) {
            TurnStep& step = report.steps[i];
            if (step.from != index && step.to != index) continue;
            if (step.verdict != Verdict::kReject || step.cause != Cause::kMislabelled) continue;
            if (report.evidence[i].foreign_object) continue;
            step.sentence +=
                fmt::format("; capture {} does not fit, the views around it do", index);
        }
    }
}

void merge(const Turn& turn, TurnReport& report) {
    std::vector<PosedView> posed;
    std::vector<Cloud> completed;
    completed.reserve(turn.size());
    for (std::size_t k = 0; k < turn.size(); ++k) {
        if (!report.poses[k]) continue;
        const Cloud* cloud = &turn.given.views[k]->cloud;
        if (!cloud->has_normals()) {
            completed.push_back(*cloud);
            completed.back().normals = turn.given.views[k]->surface.normals;
            cloud = &completed.back();
        }
        const auto& holder = turn.given.views[k]->holder;
        posed.push_back(
            {cloud, *report.poses[k], holder && holder->usable() ? &holder->surface : nullptr});
    }
    report.merged =
        merge_views(posed, {turn.settings.voxel_m, turn.settings.min_seen}, turn.for_each);
}

}  // namespace

Result<Alignment> align_views(const CaptureFacts& from_facts, const PreparedView& from,
                              const CaptureFacts& to_facts, const PreparedView& to,
                              const TurnSettings& settings, const Progress& progress,
                              const ForEach& for_each) {
    if (auto none = without_alignment(from_facts, from)) return std::move(*none);
    if (auto none = without_alignment(to_facts, to)) return std::move(*none);
    if (settings.method == TurnMethod::kPaperIcp) {
        return align_paper_icp(from.cloud, to.cloud, settings.paper_icp);
    }
    if (to_facts.mode == TurnMode::kAxisLocked) return Alignment{};
    const auto& a = from.holder;
    const auto& b = to.holder;
    if (a && b && a->usable() && b->usable()) {
        return align_held({from.surface, *a}, {to.surface, *b}, settings.align, progress, for_each);
    }
    return align_surfaces(from.surface, to.surface, settings.align, progress, for_each);
}

Result<TurnReport> finish_turn(const PreparedTurn& prepared, const TurnSettings& settings,
                               const Progress& progress, const ForEach& for_each) {
    if (Status s = check_usable(prepared); !s) return forward_error(std::move(s.error()));
    const Turn turn{prepared, settings, progress, for_each, image_faults(prepared.views)};
    TurnReport report;
    report.limits = settings.limits;
    if (Status s = find_axis(turn, report); !s) return forward_error(std::move(s.error()));
    fill_rows(turn, report);
    if (progress.cancelled()) return cancelled_error();
    const ViewChain chain = link(turn, report);
    name_contradicted(turn, chain, report);
    if (Status s = solve_poses(prepared.facts, prepared.views, chain, settings, progress, for_each,
                               report);
        !s) {
        return forward_error(std::move(s.error()));
    }
    find_common_cause(report.steps, settings.limits, report.angle_scale,
                      spans_whole_turn(settings.step_rad, report));
    if (progress.cancelled()) return cancelled_error();
    progress.tell("merging", 0, 1);
    merge(turn, report);
    progress.tell("merging", 1, 1);
    if (report.axis && !report.merged.empty()) {
        report.axis->axis.point_m = report.axis->axis.nearest_to(centroid(report.merged));
    }
    set_closures(settings.step_rad, report);
    return report;
}

Result<TurnReport> solve_turn(std::span<const TurnView> views, const TurnSettings& settings,
                              const Progress& progress, const ForEach& for_each) {
    if (views.size() < 2) {
        return input_error("{} used captures; a turn needs at least 2", views.size());
    }
    std::vector<PreparedView> prepared(views.size());
    for_each(views.size(), [&](std::size_t k) { prepared[k] = prepare_view(views[k].cloud); });
    PreparedTurn turn;
    for (std::size_t k = 0; k < views.size(); ++k) {
        turn.facts.push_back(views[k]);
        turn.views.push_back(&prepared[k]);
    }
    std::vector<Result<Alignment>> aligned(views.size() - 1, cancelled_error());
    std::atomic<std::size_t> done = 0;
    for_each(aligned.size(), [&](std::size_t i) {
        if (progress.cancelled()) return;
        aligned[i] = align_views(turn.facts[i], prepared[i], turn.facts[i + 1], prepared[i + 1],
                                 settings, progress, for_each_in_order);
        progress.tell("registration", ++done, aligned.size());
    });
    for (auto& one : aligned) {
        if (!one) return forward_error(std::move(one.error()));
        turn.steps.push_back({std::move(*one), std::nullopt});
    }
    return finish_turn(turn, settings, progress, for_each);
}

}  // namespace gripscan
