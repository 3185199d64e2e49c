#include "core/registration/solve_turn.h"

#include <algorithm>
#include <atomic>

#include "core/registration/align_surfaces.h"
#include "core/registration/merge.h"
#include "core/registration/turn_check.h"
#include "core/registration/turn_poses.h"
#include "core/registration/turn_rows.h"
#include "core/registration/view_chain.h"

namespace gripscan {
namespace {

/// Bridges over at most this many contradicted views.
constexpr std::size_t kLongestGap = 3;

/// What all parts of the solution need.
struct Turn {
    std::span<const TurnView> views;
    const TurnSettings& settings;
    const Progress& progress;
    const ForEach& for_each;
    std::vector<Surface> surfaces;
    std::vector<std::string> flaws;     ///< why a view has no surface; empty: it has one
    std::vector<Alignment> alignments;  ///< of view i onto view i + 1
};

Status prepare_surfaces(Turn& turn) {
    std::vector<Result<Surface>> made;
    made.reserve(turn.views.size());
    for (std::size_t k = 0; k < turn.views.size(); ++k) made.emplace_back(cancelled_error());
    turn.for_each(turn.views.size(),
                  [&](std::size_t k) { made[k] = make_surface(turn.views[k].cloud); });
    std::size_t usable = 0;
    for (std::size_t k = 0; k < made.size(); ++k) {
        turn.flaws.push_back(made[k] ? "" : made[k].error().message);
        turn.surfaces.push_back(made[k] ? std::move(*made[k]) : Surface{});
        if (turn.flaws[k].empty()) ++usable;
    }
    if (usable < 2) {
        return input_error("{} of {} captures have enough points; capture {}: {}", usable,
                           made.size(), turn.views.front().index,
                           turn.flaws.front().empty() ? turn.flaws.back() : turn.flaws.front());
    }
    return {};
}

/// Views that are too poor to register are no error of the recording: the steps they take part in
/// are rejected.
std::optional<Alignment> without_alignment(const Turn& turn, std::size_t from, std::size_t to) {
    for (const std::size_t k : {from, to}) {
        if (turn.flaws[k].empty()) continue;
        Alignment none;
        none.cause = Cause::kTexture;
        none.sentence = fmt::format("capture {}: {}; no texture, no light, or nothing there",
                                    turn.views[k].index, turn.flaws[k]);
        return none;
    }
    return std::nullopt;
}

Result<Alignment> align_views(const Turn& turn, std::size_t from, std::size_t to,
                              const ForEach& inner) {
    if (auto none = without_alignment(turn, from, to)) return std::move(*none);
    if (turn.settings.method == TurnMethod::kPaperIcp) {
        return align_paper_icp(turn.views[from].cloud, turn.views[to].cloud,
                               turn.settings.paper_icp);
    }
    return align_surfaces(turn.surfaces[from], turn.surfaces[to], turn.settings.align,
                          turn.progress, inner);
}

Status align_steps(Turn& turn) {
    const std::size_t steps = turn.views.size() - 1;
    std::vector<Result<Alignment>> results(steps, cancelled_error());
    std::atomic<std::size_t> done = 0;
    turn.for_each(steps, [&](std::size_t i) {
        if (turn.progress.cancelled()) return;
        results[i] = align_views(turn, i, i + 1, for_each_in_order);
        turn.progress.tell("registration", ++done, steps);
    });
    for (auto& result : results) {
        if (!result) return forward_error(std::move(result.error()));
        turn.alignments.push_back(std::move(*result));
    }
    return {};
}

/// Middle of what all views show: the part turns in place.
Eigen::Vector3d centre_of(const std::vector<Surface>& surfaces) {
    Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
    double count = 0.0;
    for (const Surface& s : surfaces) {
        if (s.size() == 0) continue;
        sum_m += s.centre_m;
        count += 1.0;
    }
    return sum_m / count;
}

/// Table 1, judged; the operator's notes overrule.
void fill_rows(const Turn& turn, TurnReport& report) {
    for (std::size_t i = 0; i < turn.alignments.size(); ++i) {
        report.steps.push_back(
            step_row(turn.views[i], turn.views[i + 1], turn.alignments[i], turn.settings.method));
        report.steps.back().index = static_cast<int>(i) + 1;
    }
    const StepsAxis axis =
        axis_from_steps(report.steps, turn.settings.axis_hint, centre_of(turn.surfaces));
    report.axis = axis.estimate;
    report.sign_source = axis.sign_source;
    for (std::size_t i = 0; i < report.steps.size(); ++i) {
        TurnStep& step = report.steps[i];
        judge_row(step, turn.views[i], turn.views[i + 1], turn.alignments[i], axis.estimate,
                  turn.settings);
        const std::string& note = turn.views[i + 1].note;
        if (!note.empty() && step.T && step.verdict != Verdict::kAccept) {
            step.verdict = Verdict::kAcceptNoted;
            step.sentence += "; accepted with note: " + note;
        }
    }
}

/// Do two views that are not neighbours fit together and to the robot?
bool bridge_holds(const Turn& turn, const std::optional<AxisEstimate>& axis, std::size_t from,
                  std::size_t to) {
    if (!axis || turn.progress.cancelled()) return false;
    const auto alignment = align_views(turn, from, to, turn.for_each);
    if (!alignment || !alignment->found) return false;
    TurnStep step = step_row(turn.views[from], turn.views[to], *alignment, turn.settings.method);
    if (!reported_rad(step)) return false;
    judge_row(step, turn.views[from], turn.views[to], *alignment, axis, turn.settings);
    return step.verdict == Verdict::kAccept;
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
        const int index = turn.views[v].index;
        for (TurnStep& step : report.steps) {
            if (step.from != index && step.to != index) continue;
            if (step.verdict != Verdict::kReject || step.cause != Cause::kMislabelled) continue;
            step.sentence +=
                fmt::format("; capture {} does not fit, the views around it do", index);
        }
    }
}

void merge(const Turn& turn, TurnReport& report) {
    std::vector<PosedView> posed;
    std::vector<Cloud> completed;
    completed.reserve(turn.views.size());
    for (std::size_t k = 0; k < turn.views.size(); ++k) {
        if (!report.poses[k]) continue;
        const Cloud* cloud = &turn.views[k].cloud;
        if (!cloud->has_normals()) {
            completed.push_back(*cloud);
            completed.back().normals = turn.surfaces[k].normals;
            cloud = &completed.back();
        }
        posed.push_back({cloud, *report.poses[k]});
    }
    report.merged =
        merge_views(posed, {turn.settings.voxel_m, turn.settings.min_seen}, turn.for_each);
}

}  // namespace

Result<TurnReport> solve_turn(std::span<const TurnView> views, const TurnSettings& settings,
                              const Progress& progress, const ForEach& for_each) {
    if (views.size() < 2) {
        return input_error("{} used captures; a turn needs at least 2", views.size());
    }
    Turn turn{.views = views,
              .settings = settings,
              .progress = progress,
              .for_each = for_each,
              .surfaces = {},
              .flaws = {},
              .alignments = {}};
    if (Status s = prepare_surfaces(turn); !s) return forward_error(std::move(s.error()));
    if (Status s = align_steps(turn); !s) return forward_error(std::move(s.error()));

    TurnReport report;
    report.limits = settings.limits;
    fill_rows(turn, report);
    const ViewChain chain = link(turn, report);
    name_contradicted(turn, chain, report);
    if (Status s = solve_poses(views, turn.surfaces, chain, settings, progress, for_each, report);
        !s) {
        return forward_error(std::move(s.error()));
    }
    find_common_cause(report.steps, settings.limits, report.angle_scale);
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

}  // namespace gripscan
