#include "core/procedure/angle_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/units.h"
#include "core/registration/turn_check.h"

namespace gripscan {
namespace {

/// Commanded angles nearer than this are the same one.
constexpr double kSameAngle_rad = 0.01 * kRadPerDeg;
/// Errors that repeat do so to this share of their size, beside their noise.
constexpr double kRepeats = 0.2;
/// Rows that must agree before a pattern over rows is believed.
constexpr std::size_t kLeastRows = 3;
/// Scans that turned by less than this share of the reported angle show something that stands.
constexpr double kStoodStill = 0.05;
/// More than this share of a step is no play of a joint.
constexpr double kLargestPlay = 0.5;
/// A row is conspicuous from this share of its limit on: accepted rows are witnesses too.
constexpr double kConspicuous = 0.5;

struct Turned {
    double icp_rad = 0.0;
    double reported_rad = 0.0;
    double error_rad = 0.0;
    double sigma_rad = 0.0;
    double limit_rad = 0.0;
};

/// Does the row's angle say nothing about the robot?
bool no_witness(Cause cause) {
    switch (cause) {
        case Cause::kOverlap:
        case Cause::kSymmetry:
        case Cause::kTexture:
        case Cause::kExposure:
        case Cause::kSettle:
        case Cause::kWrongJoint:
        case Cause::kNotConverged:
        case Cause::kLink:
            return true;
        default:
            return false;
    }
}

std::optional<Turned> turned(const TurnStep& row, const TurnLimits& limits) {
    if (!row.icp_rad || !row.error_rad || !row.independent || no_witness(row.cause)) {
        return std::nullopt;
    }
    return Turned{*row.icp_rad, *row.icp_rad - *row.error_rad, *row.error_rad,
                  row.sigma_rad.value_or(0.0), angle_limit_rad(row, limits)};
}

/// Two errors that one cause would make equal.
bool same_error(const Turned& a, double b_rad, double b_sigma_rad, const TurnLimits& limits) {
    const double noise_rad = limits.sigmas * std::hypot(a.sigma_rad, b_sigma_rad);
    return std::abs(a.error_rad - b_rad) <= std::max(noise_rad, kRepeats * std::abs(a.error_rad));
}

/// The rows up to this one that are conspicuous, this one last; broken off by the first that is not
/// or that says nothing about the angle.
std::vector<Turned> conspicuous_run(const AdvisorCase& c, const Turned& now,
                                    const TurnLimits& limits) {
    std::vector<Turned> run{now};
    for (auto row = c.before.rbegin(); row != c.before.rend(); ++row) {
        const auto one = turned(row->row, limits);
        if (!one || std::abs(one->error_rad) < kConspicuous * one->limit_rad) break;
        run.insert(run.begin(), *one);
    }
    return run;
}

std::optional<AnglePattern> turned_the_other_way(const Turned& now, bool seen_before) {
    const bool opposite = std::abs(now.icp_rad + now.reported_rad) <= now.limit_rad &&
                          std::abs(now.reported_rad) > 2.0 * now.limit_rad;
    if (!opposite) return std::nullopt;
    return AnglePattern{Cause::kSign, seen_before ? Certainty::kEstablished : Certainty::kFirstLook,
                        fmt::format("scans turned by {:+.3f} deg where the robot reports {:+.3f} "
                                    "deg: the same turn the other way",
                                    deg_from_rad(now.icp_rad), deg_from_rad(now.reported_rad))};
}

std::optional<AnglePattern> one_ratio(const std::vector<Turned>& run, const TurnLimits& limits) {
    if (run.size() < kLeastRows) return std::nullopt;
    double icp = 0.0;
    double reported = 0.0;
    for (const Turned& row : run) {
        icp += row.icp_rad * row.reported_rad;
        reported += row.reported_rad * row.reported_rad;
    }
    if (!(reported > 0.0)) return std::nullopt;
    const double ratio = icp / reported;
    if (std::abs(ratio) < kStoodStill) return std::nullopt;
    const bool explains = std::all_of(run.begin(), run.end(), [&](const Turned& row) {
        const double expected_rad = (ratio - 1.0) * row.reported_rad;
        return same_error(row, expected_rad, 0.0, limits);
    });
    if (!explains) return std::nullopt;
    return AnglePattern{
        Cause::kRatio, Certainty::kEstablished,
        fmt::format("{} steps in a row turned by {:.4f} times what the robot reports", run.size(),
                    ratio)};
}

/// A capture that carries a wrong angle spoils the step to it and, the other way, the step from it.
std::optional<AnglePattern> undone_by_this_step(const std::vector<Turned>& run,
                                                const AdvisorCase& c, const TurnLimits& limits) {
    if (run.size() != 2 || !same_error(run[1], -run[0].error_rad, run[0].sigma_rad, limits)) {
        return std::nullopt;
    }
    return AnglePattern{Cause::kMislabelled, Certainty::kEstablished,
                        fmt::format("the step before was wrong by {:+.3f} deg, this one by {:+.3f} "
                                    "deg: only capture {} between them has a wrong angle",
                                    deg_from_rad(run[0].error_rad), deg_from_rad(run[1].error_rad),
                                    c.step.row.from)};
}

std::optional<AnglePattern> to_and_fro(const std::vector<Turned>& run) {
    if (run.size() < kLeastRows) return std::nullopt;
    const auto [least, most] = std::minmax_element(
        run.begin(), run.end(),
        [](const Turned& a, const Turned& b) { return a.error_rad < b.error_rad; });
    if (least->error_rad > 0.0 || most->error_rad < 0.0) return std::nullopt;
    return AnglePattern{
        Cause::kLoose, Certainty::kEstablished,
        fmt::format("{} steps in a row wrong by {:+.3f} … {:+.3f} deg, now one way and now the "
                    "other",
                    run.size(), deg_from_rad(least->error_rad), deg_from_rad(most->error_rad))};
}

/// The experiment of halving: a ratio's error follows the step, a play's does not.
std::optional<AnglePattern> against_larger_step(const AdvisorCase& c, const Turned& now,
                                                const TurnLimits& limits) {
    for (auto attempt = c.attempts.rbegin(); attempt != c.attempts.rend(); ++attempt) {
        const auto larger = turned(attempt->row, limits);
        if (!larger || at_same_angle(c.step.row, attempt->row) ||
            std::abs(larger->error_rad) <= larger->limit_rad || larger->reported_rad == 0.0) {
            continue;
        }
        const double share = now.reported_rad / larger->reported_rad;
        const std::string numbers =
            fmt::format("error {:+.3f} deg in a step of {:.1f} deg, {:+.3f} deg in one of {:.1f}",
                        deg_from_rad(larger->error_rad), deg_from_rad(larger->reported_rad),
                        deg_from_rad(now.error_rad), deg_from_rad(now.reported_rad));
        if (same_error(now, larger->error_rad, larger->sigma_rad, limits)) {
            return AnglePattern{Cause::kBacklash, Certainty::kEstablished,
                                numbers + ": it does not follow the step"};
        }
        if (same_error(now, share * larger->error_rad, larger->sigma_rad, limits)) {
            return AnglePattern{Cause::kRatio, Certainty::kEstablished,
                                numbers + ": it follows the step"};
        }
    }
    return std::nullopt;
}

/// Residuals, tilt and slip are fine: nothing but the angle is wrong.
bool angle_alone_is_wrong(const TurnStep& row, const TurnLimits& limits) {
    return row.tilt_rad.value_or(0.0) <= limits.tilt_rad &&
           std::abs(row.slip_m.value_or(0.0)) <= limits.slip_m;
}

/// A ratio would be in every step: one before that is fine rules it out.
bool ratio_ruled_out(const AdvisorCase& c, const TurnLimits& limits) {
    if (c.before.empty()) return false;
    const auto last = turned(c.before.back().row, limits);
    return last && std::abs(last->error_rad) < kConspicuous * last->limit_rad;
}

/// Agreeing pictures are play where nothing but the angle is wrong. The views share what is hard to
/// see in them, so a small error may repeat without any cause in the robot: not established.
AnglePattern agreeing_pictures(const AdvisorCase& c, const Turned& now, std::size_t pictures,
                               const TurnLimits& limits) {
    AnglePattern pattern;
    pattern.certainty = Certainty::kReproduced;
    pattern.evidence = fmt::format("{} pictures at this angle agree on an error of {:+.3f} deg",
                                   pictures, deg_from_rad(now.error_rad));
    const bool rejected = c.step.row.verdict == Verdict::kReject;
    if (!angle_alone_is_wrong(c.step.row, limits)) {
        pattern.cause = Cause::kLoose;
        if (rejected) pattern.certainty = Certainty::kEstablished;
    } else if (std::abs(now.error_rad) < kLargestPlay * std::abs(now.reported_rad)) {
        pattern.cause = Cause::kBacklash;
        if (rejected && ratio_ruled_out(c, limits)) pattern.certainty = Certainty::kEstablished;
    }
    return pattern;
}

/// Pictures at the same angle, the robot standing: they say the same, or not.
std::optional<AnglePattern> against_same_angle(const AdvisorCase& c, const Turned& now,
                                               const TurnLimits& limits) {
    std::size_t others = 0;
    std::size_t agreeing = 0;
    double other_rad = 0.0;
    for (const JudgedStep& attempt : c.attempts) {
        const auto one = turned(attempt.row, limits);
        if (!one || !at_same_angle(c.step.row, attempt.row)) continue;
        ++others;
        other_rad = one->error_rad;
        if (same_error(now, one->error_rad, one->sigma_rad, limits)) ++agreeing;
    }
    if (others == 0) return std::nullopt;
    if (agreeing > 0) return agreeing_pictures(c, now, agreeing + 1, limits);
    return AnglePattern{Cause::kLoose, Certainty::kUnsteady,
                        fmt::format("wrong by {:+.3f} deg, then by {:+.3f} deg at the same angle "
                                    "of the robot",
                                    deg_from_rad(other_rad), deg_from_rad(now.error_rad))};
}

}  // namespace

bool at_same_angle(const TurnStep& row, const TurnStep& attempt) {
    if (!row.commanded_rad || !attempt.commanded_rad) return true;
    return std::abs(*row.commanded_rad - *attempt.commanded_rad) < kSameAngle_rad;
}

AnglePattern angle_pattern(const AdvisorCase& c, const TurnLimits& limits) {
    const auto now = turned(c.step.row, limits);
    if (!now) return {};
    const auto same = against_same_angle(c, *now, limits);
    const bool reproduced = same && same->certainty >= Certainty::kReproduced;
    if (auto sign = turned_the_other_way(*now, reproduced)) return *sign;
    const std::vector<Turned> run = conspicuous_run(c, *now, limits);
    if (auto ratio = one_ratio(run, limits)) return *ratio;
    if (auto larger = against_larger_step(c, *now, limits)) return *larger;
    if (auto undone = undone_by_this_step(run, c, limits)) return *undone;
    if (auto loose = to_and_fro(run)) return *loose;
    return same.value_or(AnglePattern{});
}

}  // namespace gripscan
