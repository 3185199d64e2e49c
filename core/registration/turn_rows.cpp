#include "core/registration/turn_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/registration/quality.h"

namespace gripscan {
namespace {

/// Cosine between hint and axis from which on the hint decides.
constexpr double kLeastHint = 0.2;

double largest_change_rad(const std::optional<std::array<double, 5>>& a,
                          const std::optional<std::array<double, 5>>& b) {
    double change = 0.0;
    if (!a || !b) return change;
    for (std::size_t j = 0; j < a->size(); ++j) {
        change = std::max(change, std::abs((*b)[j] - (*a)[j]));
    }
    return change;
}

double moved_during_exposure_rad(const CaptureFacts& view) {
    return std::abs(difference(view.joint6_rad, view.joint6_after_rad).value_or(0.0));
}

}  // namespace

std::optional<double> joint6_rad(const CaptureFacts& view) {
    if (view.joint6_rad && view.joint6_after_rad) {
        return 0.5 * (*view.joint6_rad + *view.joint6_after_rad);
    }
    return view.joint6_rad ? view.joint6_rad : view.joint6_after_rad;
}

std::optional<double> difference(std::optional<double> from, std::optional<double> to) {
    if (!from || !to) return std::nullopt;
    return *to - *from;
}

std::optional<double> reported_rad(const TurnStep& step) {
    return step.robot_rad ? step.robot_rad : step.commanded_rad;
}

TurnStep step_row(const CaptureFacts& from, const CaptureFacts& to, const Alignment& alignment,
                  TurnMethod method) {
    TurnStep step;
    step.from = from.index;
    step.to = to.index;
    step.attempts = to.attempts;
    step.commanded_rad = difference(from.commanded_rad, to.commanded_rad);
    step.robot_rad = difference(joint6_rad(from), joint6_rad(to));
    if (!alignment.found || alignment.cause == Cause::kNotConverged) return step;
    step.T = alignment.T_target_source;
    step.icp_rad = alignment.angle_rad;
    step.overlap = alignment.overlap;
    step.rms_m = alignment.rms_m;
    step.median_m = alignment.median_m;
    step.p90_m = alignment.p90_m;
    if (method == TurnMethod::kTurn) {
        step.sigma_rad = alignment.sigma_angle_rad;
        step.observability = alignment.observability;
    }
    return step;
}

StepsAxis axis_from_steps(std::span<const TurnStep> steps,
                          const std::optional<Eigen::Vector3d>& axis_hint,
                          const Eigen::Vector3d& centre_m) {
    std::vector<Pose> motions;
    for (const TurnStep& step : steps) {
        if (step.T && step.mode == TurnMode::kFree) motions.push_back(*step.T);
    }
    StepsAxis axis;
    axis.estimate = estimate_axis(motions, centre_m);
    if (axis_hint) axis.sign_source = SignSource::kAxisHint;
    if (!axis.estimate) return axis;
    Eigen::Vector3d& direction = axis.estimate->axis.direction;
    double agreement = axis_hint ? direction.dot(axis_hint->normalized()) : 0.0;
    // A hint across the axis says nothing about its sign.
    const bool hinted = std::abs(agreement) > kLeastHint;
    if (!hinted) {
        agreement = 0.0;
        axis.sign_source = SignSource::kAssumed;
    }
    for (const TurnStep& step : steps) {
        if (hinted || !step.T || !reported_rad(step) || step.mode != TurnMode::kFree) continue;
        if (step.robot_rad) axis.sign_source = SignSource::kJoint;
        agreement += deviation_from(axis.estimate->axis, *step.T).angle_rad * *reported_rad(step);
    }
    if (agreement < 0.0) direction = -direction;
    return axis;
}

void compare_with_axis(TurnStep& step, const std::optional<AxisEstimate>& axis) {
    if (step.T && axis) {
        const AxisDeviation d = deviation_from(axis->axis, *step.T);
        step.icp_rad = d.angle_rad;
        step.tilt_rad = d.tilt_rad;
        step.axis_offset_m = d.offset_m;
        step.slip_m = d.slip_m;
    }
    // Locked to the axis it would be the robot's angle against itself.
    if (step.mode == TurnMode::kAxisLocked) return;
    if (step.icp_rad && reported_rad(step)) step.error_rad = *step.icp_rad - *reported_rad(step);
}

std::optional<Alignment> without_alignment(const CaptureFacts& facts, const PreparedView& view) {
    if (view.usable()) return std::nullopt;
    Alignment none;
    none.cause = view.flaw_cause;
    none.sentence = fmt::format(
        "capture {}: {}{}", facts.index, view.flaw,
        view.flaw_cause == Cause::kTexture ? "; no texture, no light, or nothing there" : "");
    return none;
}

StepEvidence evidence_of(const CaptureFacts& from, const CaptureFacts& to,
                         const Alignment& alignment, TurnMethod method) {
    StepEvidence evidence;
    evidence.found = alignment.found && alignment.cause != Cause::kNotConverged;
    if (!evidence.found) {
        evidence.why_not_found = alignment.sentence;
        if (alignment.cause != Cause::kNone) evidence.cause_not_found = alignment.cause;
    }
    evidence.starts_agree = alignment.starts_agree;
    evidence.least_observability = kLeastObservability;
    evidence.joint6_moved_rad =
        std::max(moved_during_exposure_rad(from), moved_during_exposure_rad(to));
    evidence.other_joints_moved_rad =
        largest_change_rad(from.other_joints_rad, to.other_joints_rad);
    evidence.paper_icp = method == TurnMethod::kPaperIcp;
    return evidence;
}

}  // namespace gripscan
