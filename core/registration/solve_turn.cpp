#include "core/registration/solve_turn.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "core/registration/align_surfaces.h"
#include "core/registration/axis_estimate.h"
#include "core/registration/joint_solution.h"
#include "core/registration/merge.h"
#include "core/registration/turn_check.h"
#include "core/registration/view_chain.h"

namespace gripscan {
namespace {

/// A turn whose surface resists less than this share of the possible is not observable.
constexpr double kLeastObservability = 0.08;
/// What a robot's joint reading is worth, and a merely commanded angle.
constexpr double kReadingSigma_rad = 0.02 * kRadPerDeg;
constexpr double kCommandSigma_rad = 0.05 * kRadPerDeg;
/// Bridges over at most this many contradicted views.
constexpr std::size_t kLongestGap = 3;

/// Everything the parts below hand to each other.
struct Turn {
    std::span<const TurnView> views;
    const TurnSettings& settings;
    const Progress& progress;
    const ForEach& for_each;
    std::vector<Surface> surfaces;
    std::vector<Alignment> alignments;  ///< of view i onto view i + 1
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
};

/// Joint 6 of a view: the mean of the readings around the exposure.
std::optional<double> joint6(const TurnView& view) {
    if (view.joint6_rad && view.joint6_after_rad) {
        return 0.5 * (*view.joint6_rad + *view.joint6_after_rad);
    }
    return view.joint6_rad ? view.joint6_rad : view.joint6_after_rad;
}

std::optional<double> difference(std::optional<double> from, std::optional<double> to) {
    if (!from || !to) return std::nullopt;
    return *to - *from;
}

Status prepare_surfaces(Turn& turn) {
    std::vector<Result<Surface>> made;
    made.reserve(turn.views.size());
    for (std::size_t k = 0; k < turn.views.size(); ++k) made.emplace_back(cancelled_error());
    turn.for_each(turn.views.size(),
                  [&](std::size_t k) { made[k] = make_surface(turn.views[k].cloud); });
    for (std::size_t k = 0; k < made.size(); ++k) {
        if (!made[k]) {
            return input_error("capture {}: {}", turn.views[k].index, made[k].error().message);
        }
        turn.surfaces.push_back(std::move(*made[k]));
    }
    for (const Surface& s : turn.surfaces) {
        turn.centre_m += s.centre_m / static_cast<double>(turn.surfaces.size());
    }
    return {};
}

Result<Alignment> align_views(const Turn& turn, std::size_t from, std::size_t to,
                              const ForEach& inner) {
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

/// The step's row as far as it does not need the common axis.
TurnStep first_row(const Turn& turn, std::size_t i) {
    const TurnView& a = turn.views[i];
    const TurnView& b = turn.views[i + 1];
    const Alignment& alignment = turn.alignments[i];
    TurnStep step;
    step.index = static_cast<int>(i) + 1;
    step.from = a.index;
    step.to = b.index;
    step.attempts = b.attempts;
    step.commanded_rad = difference(a.commanded_rad, b.commanded_rad);
    step.robot_rad = difference(joint6(a), joint6(b));
    if (!alignment.found) return step;
    step.T = alignment.T_target_source;
    step.icp_rad = alignment.angle_rad;
    step.overlap = alignment.overlap;
    step.rms_m = alignment.rms_m;
    if (turn.settings.method == TurnMethod::kTurn) {
        step.sigma_rad = alignment.sigma_angle_rad;
        step.observability = alignment.observability;
    }
    return step;
}

std::optional<double> reported(const TurnStep& step) {
    return step.robot_rad ? step.robot_rad : step.commanded_rad;
}

/// The axis from the steps alone, its sign settled by the hint or by the robot.
std::optional<AxisEstimate> axis_from_steps(const Turn& turn, TurnReport& report) {
    std::vector<StepMotion> motions;
    for (const TurnStep& step : report.steps) {
        if (step.T) motions.push_back({*step.T, step.sigma_rad.value_or(1e-3)});
    }
    auto estimate = estimate_axis(motions, turn.centre_m);
    if (!estimate) return estimate;
    Eigen::Vector3d& direction = estimate->axis.direction;
    if (turn.settings.axis_hint) {
        report.sign_source = SignSource::kAxisHint;
        if (direction.dot(*turn.settings.axis_hint) < 0.0) direction = -direction;
        return estimate;
    }
    double agreement = 0.0;
    bool measured = false;
    for (const TurnStep& step : report.steps) {
        if (!step.T || !reported(step)) continue;
        measured = measured || step.robot_rad.has_value();
        agreement += deviation_from(estimate->axis, *step.T).angle_rad * *reported(step);
    }
    report.sign_source = measured ? SignSource::kJoint : SignSource::kAssumed;
    if (agreement < 0.0) direction = -direction;
    return estimate;
}

double largest_change(const std::optional<std::array<double, 5>>& a,
                      const std::optional<std::array<double, 5>>& b) {
    double change = 0.0;
    if (!a || !b) return change;
    for (std::size_t j = 0; j < a->size(); ++j)
        change = std::max(change, std::abs((*b)[j] - (*a)[j]));
    return change;
}

double moved_during_exposure(const TurnView& view) {
    return std::abs(difference(view.joint6_rad, view.joint6_after_rad).value_or(0.0));
}

void complete_and_judge(const Turn& turn, std::size_t i, const std::optional<AxisEstimate>& axis,
                        TurnStep& step) {
    const TurnView& a = turn.views[i];
    const TurnView& b = turn.views[i + 1];
    if (step.T && axis) {
        const AxisDeviation d = deviation_from(axis->axis, *step.T);
        step.icp_rad = d.angle_rad;
        step.tilt_rad = d.tilt_rad;
        step.axis_offset_m = d.offset_m;
        step.slip_m = d.slip_m;
    }
    if (step.icp_rad && reported(step)) step.error_rad = *step.icp_rad - *reported(step);
    StepEvidence evidence;
    evidence.found = turn.alignments[i].found && turn.alignments[i].cause != Cause::kNotConverged;
    evidence.starts_agree = turn.alignments[i].starts_agree;
    evidence.least_observability = kLeastObservability;
    evidence.expected_rad = reported(step);
    evidence.joint6_moved_rad = std::max(moved_during_exposure(a), moved_during_exposure(b));
    evidence.other_joints_moved_rad = largest_change(a.other_joints_rad, b.other_joints_rad);
    evidence.paper_icp = turn.settings.method == TurnMethod::kPaperIcp;
    judge_step(step, evidence, turn.settings.limits);
}

bool trusted(const TurnStep& step) {
    return step.verdict != Verdict::kReject;
}

/// Do two views that are not neighbours fit together and to the robot?
bool bridge_holds(const Turn& turn, const std::optional<AxisEstimate>& axis, std::size_t from,
                  std::size_t to) {
    if (!axis) return false;
    const auto alignment = align_views(turn, from, to, turn.for_each);
    if (!alignment || !alignment->found) return false;
    TurnStep step;
    step.commanded_rad = difference(turn.views[from].commanded_rad, turn.views[to].commanded_rad);
    step.robot_rad = difference(joint6(turn.views[from]), joint6(turn.views[to]));
    if (!reported(step)) return false;
    step.T = alignment->T_target_source;
    step.sigma_rad = alignment->sigma_angle_rad;
    step.observability = alignment->observability;
    const AxisDeviation d = deviation_from(axis->axis, *step.T);
    step.icp_rad = d.angle_rad;
    step.tilt_rad = d.tilt_rad;
    step.slip_m = d.slip_m;
    step.error_rad = d.angle_rad - *reported(step);
    StepEvidence evidence;
    evidence.found = true;
    evidence.starts_agree = alignment->starts_agree;
    evidence.least_observability = kLeastObservability;
    judge_step(step, evidence, turn.settings.limits);
    return step.verdict == Verdict::kAccept;
}

/// Steps into and out of a view that was bridged over: the view's label is what does not fit.
void name_contradicted(const Turn& turn, const ViewChain& chain, TurnReport& report) {
    for (const std::size_t v : chain.bridged) {
        for (TurnStep& step : report.steps) {
            const int index = turn.views[v].index;
            if ((step.from != index && step.to != index) || trusted(step)) continue;
            if (step.cause != Cause::kMislabelled) continue;
            step.sentence +=
                fmt::format("; capture {} does not fit, the views around it do", index);
        }
    }
}

/// The turn of every view since the first one of the chain, as reported; where nothing was
/// reported, as the scans say.
std::vector<JointView> joint_views(const Turn& turn, const ViewChain& chain,
                                   const TurnReport& report) {
    std::vector<JointView> views;
    double angle = 0.0;
    for (std::size_t k = 0; k < chain.trusted.size(); ++k) {
        const std::size_t v = chain.trusted[k];
        double sigma = kReadingSigma_rad;
        if (k > 0) {
            const std::size_t before = chain.trusted[k - 1];
            const auto joint = difference(joint6(turn.views[before]), joint6(turn.views[v]));
            const auto command =
                difference(turn.views[before].commanded_rad, turn.views[v].commanded_rad);
            if (!joint) sigma = kCommandSigma_rad;
            if (joint || command) {
                angle += joint ? *joint : *command;
            } else {
                // Nobody reported an angle: the scans' own, loosely held.
                for (std::size_t i = before; i < v; ++i)
                    angle += report.steps[i].icp_rad.value_or(0);
                sigma = 1.0;
            }
        }
        views.push_back({&turn.surfaces[v], angle, sigma});
    }
    return views;
}

Pose chained(const TurnReport& report) {
    Pose T = Pose::Identity();
    for (const TurnStep& step : report.steps) {
        if (step.T) T = *step.T * T;
    }
    return T;
}

/// How far a pose is from the nominal turn, and what that does to the axis point.
Closure closure_of(const Pose& T_last_first, const Axis& axis, double nominal_rad) {
    const Pose rest = turn_about(axis, nominal_rad).inverse() * T_last_first;
    return {rotation_angle_rad(rest.linear()), (rest * axis.point_m - axis.point_m).norm()};
}

void close(const Turn& turn, const Pose* T_last_first, TurnReport& report) {
    double nominal = 0.0;
    for (const TurnStep& step : report.steps) {
        if (!step.T || !reported(step)) return;
        nominal += *reported(step);
    }
    const double full = std::copysign(2.0 * std::numbers::pi, nominal);
    if (!report.axis || std::abs(nominal - full) > 0.5 * std::abs(turn.settings.step_rad)) return;
    report.closure_before = closure_of(chained(report), report.axis->axis, nominal);
    report.closure_after = T_last_first ? closure_of(*T_last_first, report.axis->axis, nominal)
                                        : *report.closure_before;
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

/// Poses of the trusted views relative to the first used capture, which may itself be in doubt:
/// then the first step's own motion links it.
void set_poses(const Turn& turn, const ViewChain& chain, const std::vector<Pose>& T_view_chain,
               TurnReport& report) {
    Pose T_chain_first = Pose::Identity();
    for (std::size_t i = 0; i < chain.trusted.front(); ++i) {
        if (report.steps[i].T) T_chain_first = *report.steps[i].T * T_chain_first;
    }
    report.poses.assign(turn.views.size(), std::nullopt);
    for (std::size_t k = 0; k < chain.trusted.size(); ++k) {
        report.poses[chain.trusted[k]] = (T_view_chain[k] * T_chain_first).inverse();
    }
}

/// Without a joint solution (the paper's method, or no axis): the steps composed.
std::vector<Pose> composed(const ViewChain& chain, const TurnReport& report) {
    std::vector<Pose> poses{Pose::Identity()};
    for (std::size_t k = 1; k < chain.trusted.size(); ++k) {
        Pose T = poses.back();
        for (std::size_t i = chain.trusted[k - 1]; i < chain.trusted[k]; ++i) {
            if (report.steps[i].T) T = *report.steps[i].T * T;
        }
        poses.push_back(T);
    }
    return poses;
}

Status solve_poses(const Turn& turn, const ViewChain& chain, TurnReport& report) {
    std::vector<Pose> poses = composed(chain, report);
    const bool jointly =
        turn.settings.method == TurnMethod::kTurn && report.axis && chain.trusted.size() > 2;
    if (jointly) {
        const auto views = joint_views(turn, chain, report);
        auto solution = solve_jointly(views, report.axis->axis, {}, turn.progress, turn.for_each);
        if (!solution) return forward_error(std::move(solution.error()));
        report.axis = solution->axis;
        if (solution->scale_estimated) report.angle_scale = solution->scale;
        poses = std::move(solution->T_view_first);
    }
    set_poses(turn, chain, poses, report);
    const bool whole = chain.trusted.size() == turn.views.size();
    if (jointly && whole) {
        close(turn, &poses.back(), report);
    } else {
        close(turn, nullptr, report);
    }
    return {};
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
              .alignments = {}};
    if (Status s = prepare_surfaces(turn); !s) return forward_error(std::move(s.error()));
    if (Status s = align_steps(turn); !s) return forward_error(std::move(s.error()));

    TurnReport report;
    report.limits = settings.limits;
    for (std::size_t i = 0; i + 1 < views.size(); ++i) report.steps.push_back(first_row(turn, i));
    report.axis = axis_from_steps(turn, report);
    for (std::size_t i = 0; i < report.steps.size(); ++i) {
        complete_and_judge(turn, i, report.axis, report.steps[i]);
    }
    std::vector<bool> step_trusted;
    for (std::size_t i = 0; i < report.steps.size(); ++i) {
        TurnStep& step = report.steps[i];
        if (!views[i + 1].note.empty() && step.T && step.verdict != Verdict::kAccept) {
            step.verdict = Verdict::kAcceptNoted;
            step.sentence += "; accepted with note: " + views[i + 1].note;
        }
        step_trusted.push_back(trusted(step));
    }
    const auto steps_axis = report.axis;
    const ViewChain chain =
        link_views(step_trusted, kLongestGap, [&](std::size_t a, std::size_t b) {
            return !progress.cancelled() && bridge_holds(turn, steps_axis, a, b);
        });
    name_contradicted(turn, chain, report);
    if (Status s = solve_poses(turn, chain, report); !s) return forward_error(std::move(s.error()));
    find_common_cause(report.steps, settings.limits, report.angle_scale);
    if (progress.cancelled()) return cancelled_error();
    progress.tell("merging", 0, 1);
    merge(turn, report);
    progress.tell("merging", 1, 1);
    if (report.axis && !report.merged.empty()) {
        report.axis->axis.point_m = report.axis->axis.nearest_to(centroid(report.merged));
    }
    return report;
}

}  // namespace gripscan
