#include "core/registration/common_cause.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/registration/turn_check.h"

namespace gripscan {
namespace {

/// A ratio of angles this near 1 may be estimated and is no fault (contract).
constexpr double kHarmlessRatio = 0.003;
/// Ratios of the steps are told from their noise beyond this.
constexpr double kPlainRatio = 0.05;
/// Scans that turn by less than this share of what is reported show something that stands.
constexpr double kStoodStill = 0.05;
/// A closed turn shows the robot's own ratio; steps that differ from it by more than this show
/// depth that is distorted. Twice what healthy surfaces differ (their systematic share is below 1
/// %).
constexpr double kDistorted = 0.02;
/// Lost motion of a joint is smaller than this, and than this share of the step: more than that
/// is another capture than the one named.
constexpr double kLargestBacklash_rad = 3.0 * kRadPerDeg;
constexpr double kLargestBacklash = 0.35;

double reported_of(const TurnStep& step) {
    return *step.icp_rad - *step.error_rad;
}

void name(TurnStep& step, Cause cause, std::string sentence) {
    step.cause = cause;
    step.sentence = std::move(sentence);
}

struct Sums {
    double icp_rad = 0.0;
    double reported_rad = 0.0;
    std::size_t counted = 0;
};

/// Of the steps whose angles are measured and known.
Sums sums_of(std::span<const TurnStep> steps) {
    Sums sums;
    for (const TurnStep& step : steps) {
        if (!step.icp_rad || !step.error_rad || step.cause == Cause::kSymmetry) continue;
        sums.icp_rad += *step.icp_rad;
        sums.reported_rad += reported_of(step);
        ++sums.counted;
    }
    return sums;
}

/// Nine of ten steps turn by r times what is reported.
bool explained_by(double r, std::span<const TurnStep> steps, std::size_t counted,
                  const TurnLimits& limits) {
    std::size_t n = 0;
    for (const TurnStep& step : steps) {
        if (!step.icp_rad || !step.error_rad) continue;
        if (std::abs(*step.icp_rad - r * reported_of(step)) <= angle_limit_rad(step, limits)) ++n;
    }
    return n * 10 >= counted * 9;
}

void name_sign(std::span<TurnStep> steps) {
    for (TurnStep& step : steps) {
        if (!step.error_rad) continue;
        step.verdict = Verdict::kReject;
        name(step, Cause::kSign,
             fmt::format("scans turned by {:+.3f} deg, robot by {:+.3f} deg, and so in every step: "
                         "the joint's direction is the other way round",
                         deg_from_rad(*step.icp_rad), deg_from_rad(reported_of(step))));
    }
}

void name_ratio(std::span<TurnStep> steps, double ratio) {
    for (TurnStep& step : steps) {
        if (!step.error_rad || step.cause == Cause::kSymmetry) continue;
        if (step.verdict == Verdict::kAccept) step.verdict = Verdict::kCheck;
        name(step, Cause::kRatio,
             fmt::format("every turn is {:.4f} times what the robot reports; {}", ratio,
                         step.sentence));
    }
}

/// Only steps whose angle is off: the others are right in spite of the distortion.
void name_distortion(std::span<TurnStep> steps, double ratio) {
    for (TurnStep& step : steps) {
        if (step.cause != Cause::kMislabelled) continue;
        name(step, Cause::kDepthDistortion,
             fmt::format("every step turns by {:.4f} times what the robot reports while the whole "
                         "turn closes: depth is distorted, check the rig; {}",
                         ratio, step.sentence));
    }
}

/// The sign or one ratio in all steps; true if that is what is wrong.
bool name_proportional(std::span<TurnStep> steps, const TurnLimits& limits,
                       std::optional<double> scale, bool closed) {
    const Sums sums = sums_of(steps);
    if (sums.counted < 3 || std::abs(sums.reported_rad) < 1e-6) return false;
    const double ratio = sums.icp_rad / sums.reported_rad;
    if (ratio < 0.0 && explained_by(-1.0, steps, sums.counted, limits)) {
        name_sign(steps);
        return true;
    }
    const bool common = ratio > kStoodStill && explained_by(ratio, steps, sums.counted, limits);
    const bool by_joint = scale && std::abs(*scale - 1.0) > kHarmlessRatio;
    if (closed && !by_joint && common && std::abs(ratio - 1.0) > kDistorted) {
        name_distortion(steps, ratio);
        return true;
    }
    const bool by_steps = common && std::abs(ratio - 1.0) > kPlainRatio;
    if (!by_steps && !by_joint) return false;
    name_ratio(steps, by_joint ? *scale : ratio);
    return true;
}

/// The angle alone is off, and by no more than a joint can lose.
bool lost_motion(const TurnStep& step, const TurnLimits& limits) {
    if (step.cause != Cause::kMislabelled || !step.error_rad) return false;
    if (std::abs(*step.error_rad) <= angle_limit_rad(step, limits)) return false;
    const double most =
        std::min(kLargestBacklash_rad, kLargestBacklash * std::abs(reported_of(step)));
    return std::abs(*step.error_rad) <= most;
}

bool fine(std::span<const TurnStep> steps, std::ptrdiff_t i) {
    if (i < 0 || i >= static_cast<std::ptrdiff_t>(steps.size())) return true;
    return steps[static_cast<std::size_t>(i)].cause == Cause::kNone;
}

/// One step that turns too little or too much about the right axis among good ones, alone or with
/// the next one making up for it: the joint's reading is not the part's angle.
void name_backlash(std::span<TurnStep> steps, const TurnLimits& limits) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (!lost_motion(steps[i], limits) || !fine(steps, static_cast<std::ptrdiff_t>(i) - 1))
            continue;
        const bool made_up = i + 1 < steps.size() && lost_motion(steps[i + 1], limits) &&
                             std::abs(*steps[i].error_rad + *steps[i + 1].error_rad) <=
                                 angle_limit_rad(steps[i], limits);
        const std::size_t last = made_up ? i + 1 : i;
        if (!fine(steps, static_cast<std::ptrdiff_t>(last) + 1)) continue;
        const std::string tail =
            made_up ? fmt::format(
                          "; the steps into and out of capture {} cancel each other: lost "
                          "motion (backlash) of the joint there",
                          steps[i].to)
                    : std::string(
                          "; same axis, and the steps around it are right: lost motion "
                          "(backlash) of the joint");
        for (std::size_t k = i; k <= last; ++k) {
            name(steps[k], Cause::kBacklash, steps[k].sentence + tail);
        }
        i = last;
    }
}

/// A part that slips moves once, or on and on to the same side; one that is loose moves to and fro
/// or tilts.
void name_loose(std::span<TurnStep> steps) {
    std::vector<TurnStep*> moved;
    bool forth = false;
    bool back = false;
    bool tilted = false;
    for (TurnStep& step : steps) {
        if (step.cause != Cause::kSlip && step.cause != Cause::kLoose) continue;
        moved.push_back(&step);
        tilted = tilted || step.cause == Cause::kLoose;
        if (step.cause != Cause::kSlip) continue;
        (step.slip_m.value_or(0.0) > 0.0 ? forth : back) = true;
    }
    if (moved.size() < 2 || !(tilted || (forth && back))) return;
    for (TurnStep* step : moved) {
        if (step->cause == Cause::kLoose) continue;
        name(*step, Cause::kLoose,
             step->sentence + fmt::format("; {} steps move to different sides: the part is loose",
                                          moved.size()));
    }
}

}  // namespace

void find_common_cause(std::span<TurnStep> steps, const TurnLimits& limits,
                       std::optional<double> scale, bool closed) {
    if (name_proportional(steps, limits, scale, closed)) return;
    name_backlash(steps, limits);
    name_loose(steps);
}

}  // namespace gripscan
