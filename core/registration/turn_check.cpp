#include "core/registration/turn_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/units.h"
#include "core/registration/quality.h"

namespace gripscan {
namespace {

/// Scans that turned by less than this share of the reported angle show something that stands.
constexpr double kStoodStill = 0.05;
/// With less than this many times the least observability, standing still says little.
constexpr double kHardlyShown = 2.0;

/// One limit: how far the value is from it (1 = on it), and how that reads.
struct Criterion {
    double excess = 0.0;
    Cause cause = Cause::kNone;
    std::string sentence;
};

Criterion angle_criterion(const TurnStep& step, const StepEvidence& evidence,
                          const TurnLimits& limits) {
    if (!step.error_rad) return {};
    const double limit = angle_limit_rad(step, limits);
    const double reported_rad = *step.icp_rad - *step.error_rad;
    const bool stood_still = std::abs(*step.icp_rad) < kStoodStill * std::abs(reported_rad);
    // Our estimate from many starts is not that wrong by itself: the capture is not what its label
    // says. Plain ICP from one start has more likely stopped somewhere, and a surface that hardly
    // shows its turn looks best unturned.
    const bool hardly_shown =
        step.observability && *step.observability < kHardlyShown * evidence.least_observability;
    const Cause cause = evidence.paper_icp            ? Cause::kNotConverged
                        : stood_still && hardly_shown ? Cause::kSymmetry
                                                      : Cause::kMislabelled;
    return {
        std::abs(*step.error_rad) / limit, cause,
        fmt::format("scans turned by {:.3f} deg, robot by {:.3f} deg: error {:+.3f} deg, limit "
                    "{:.3f} deg{}",
                    deg_from_rad(*step.icp_rad), deg_from_rad(reported_rad),
                    deg_from_rad(*step.error_rad), deg_from_rad(limit),
                    cause == Cause::kSymmetry
                        ? "; nothing turned, and the surface hardly shows a turn: it may look the "
                          "same all around the axis"
                    : stood_still ? "; nothing turned: is there a still background in the clouds? "
                                    "A region keeps it out"
                                  : "")};
}

Criterion overlap_criterion(const TurnStep& step, const TurnLimits& limits) {
    if (!step.overlap || limits.overlap <= 0.0) return {};
    return {limits.overlap / std::max(*step.overlap, 1e-3), Cause::kOverlap,
            fmt::format("overlap {:.0f} %, limit {:.0f} %: the step is too large",
                        100.0 * *step.overlap, 100.0 * limits.overlap)};
}

Criterion slip_criterion(const TurnStep& step, const TurnLimits& limits) {
    if (!step.slip_m) return {};
    return {std::abs(*step.slip_m) / limits.slip_m, Cause::kSlip,
            fmt::format("slip of {:+.2f} mm along the axis, limit {:.2f} mm",
                        kMmPerM * *step.slip_m, kMmPerM * limits.slip_m)};
}

Criterion tilt_criterion(const TurnStep& step, const TurnLimits& limits) {
    if (!step.tilt_rad) return {};
    return {*step.tilt_rad / limits.tilt_rad, Cause::kLoose,
            fmt::format("turned about an axis tilted by {:.2f} deg, limit {:.2f} deg",
                        deg_from_rad(*step.tilt_rad), deg_from_rad(limits.tilt_rad))};
}

Criterion misfit_criterion(const StepEvidence& evidence) {
    if (!evidence.misfit) return {};
    return {*evidence.misfit / kMostMisfit, Cause::kSymmetry,
            fmt::format("locked to the axis, the surfaces miss each other by {:.1f} times their "
                        "noise, limit {:.1f}: the part did not turn as the robot says",
                        *evidence.misfit, kMostMisfit)};
}

/// What makes the estimate worthless whatever its numbers say; nothing: it may be worth something.
std::optional<Criterion> no_answer(const TurnStep& step, const StepEvidence& evidence) {
    const auto because = [](Cause cause, std::string sentence) {
        return std::optional(Criterion{0.0, cause, std::move(sentence)});
    };
    if (!evidence.found) {
        return because(evidence.cause_not_found, evidence.why_not_found.empty()
                                                     ? "no alignment of the two clouds was found"
                                                     : evidence.why_not_found);
    }
    // Locked to the axis, the turn is the robot's: neither sigma nor observability are asked.
    if (evidence.paper_icp || step.mode == TurnMode::kAxisLocked) return std::nullopt;
    if (step.sigma_rad && !(*step.sigma_rad < kLargestSigma_rad)) {
        return because(Cause::kNotConverged,
                       fmt::format("the turn is known to {:.1f} deg only, which decides nothing",
                                   deg_from_rad(*step.sigma_rad)));
    }
    if (step.observability && !(*step.observability >= evidence.least_observability)) {
        return because(Cause::kSymmetry,
                       fmt::format("the surface does not show this turn (observability {:.2f}, "
                                   "least {:.2f}): it looks the same all around the axis",
                                   *step.observability, evidence.least_observability));
    }
    if (!evidence.starts_agree) {
        return because(Cause::kSymmetry,
                       "different starts end in different poses that fit equally well");
    }
    return std::nullopt;
}

/// Views that share little show neither a pose nor a symmetry.
void explain_by_overlap(Criterion& why, const StepEvidence& evidence, const TurnLimits& limits) {
    const bool open = why.cause == Cause::kNotConverged || why.cause == Cause::kSymmetry;
    if (!open || !step_too_large(evidence, limits)) return;
    why.cause = Cause::kOverlap;
    why.sentence = fmt::format(
        "turned as the robot says, the views share {:.0f} % of the surface, limit {:.0f} %: the "
        "step is too large; {}",
        100.0 * evidence.as_reported->matched, 100.0 * limits.overlap, why.sentence);
}

bool not_usable(TurnStep& step, const StepEvidence& evidence, const TurnLimits& limits) {
    auto why = no_answer(step, evidence);
    if (!why) return false;
    explain_by_overlap(*why, evidence, limits);
    step.verdict = Verdict::kReject;
    step.cause = why->cause;
    step.sentence = std::move(why->sentence);
    return true;
}

void say_locked(TurnStep& step, const StepEvidence& evidence) {
    step.cause = Cause::kSymmetry;
    step.sentence = fmt::format(
        "locked to the axis: the robot's {:.3f} deg repeated, not measured; the surfaces fit under "
        "it to {:.1f} times their noise, limit {:.1f}",
        deg_from_rad(step.icp_rad.value_or(0.0)), evidence.misfit.value_or(0.0), kMostMisfit);
}

/// The joints did not do what a step is: nothing that was measured makes up for that.
bool is_void(TurnStep& step, const StepEvidence& evidence) {
    if (evidence.other_joints_moved_rad > kJointStill_rad) {
        step.cause = Cause::kWrongJoint;
        step.sentence = fmt::format("another joint moved by {:.3f} deg, limit {:.3f} deg",
                                    deg_from_rad(evidence.other_joints_moved_rad),
                                    deg_from_rad(kJointStill_rad));
    } else if (evidence.joint6_moved_rad > kJointStill_rad) {
        step.cause = Cause::kSettle;
        step.sentence =
            fmt::format("joint 6 moved by {:.3f} deg during the exposure, limit {:.3f} deg",
                        deg_from_rad(evidence.joint6_moved_rad), deg_from_rad(kJointStill_rad));
    } else {
        return false;
    }
    step.verdict = Verdict::kReject;
    return true;
}

}  // namespace

double angle_limit_rad(const TurnStep& step, const TurnLimits& limits) {
    return std::max(limits.angle_rad, limits.sigmas * step.sigma_rad.value_or(0.0));
}

bool step_too_large(const StepEvidence& evidence, const TurnLimits& limits) {
    return evidence.as_reported && evidence.as_reported->matched < limits.overlap &&
           evidence.as_reported->contradicted <= kMostFloating;
}

void judge_step(TurnStep& step, const StepEvidence& evidence, const TurnLimits& limits) {
    step.cause = Cause::kNone;
    if (is_void(step, evidence) || not_usable(step, evidence, limits)) return;
    const std::array<Criterion, 5> criteria{
        angle_criterion(step, evidence, limits), overlap_criterion(step, limits),
        slip_criterion(step, limits), tilt_criterion(step, limits), misfit_criterion(evidence)};
    const Criterion& worst = *std::max_element(
        criteria.begin(), criteria.end(),
        [](const Criterion& a, const Criterion& b) { return a.excess < b.excess; });
    if (worst.excess <= 1.0 && step.independent) {
        step.verdict = Verdict::kAccept;
        step.sentence = step.error_rad ? fmt::format("agrees with the robot: error {:+.3f} deg",
                                                     deg_from_rad(*step.error_rad))
                                       : "within all limits; the robot's angle is not known";
        return;
    }
    if (worst.excess <= 1.0) {
        step.verdict = Verdict::kCheck;
        if (step.mode == TurnMode::kAxisLocked) return say_locked(step, evidence);
        step.sentence = "agrees with the robot, but was not found independently of it";
        return;
    }
    step.verdict = worst.excess < kCheckFactor ? Verdict::kCheck : Verdict::kReject;
    step.cause = worst.cause;
    step.sentence = worst.sentence;
    // Low overlap explains a wrong angle, tilt or slip.
    if (criteria[1].excess > 1.0) {
        step.cause = Cause::kOverlap;
        step.sentence = criteria[1].sentence;
    }
}

}  // namespace gripscan
