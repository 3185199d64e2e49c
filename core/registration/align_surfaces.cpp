#include "core/registration/align_surfaces.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "core/registration/point_to_plane.h"
#include "core/registration/quality.h"
#include "core/registration/search.h"
#include "core/registration/texture_rows.h"

namespace gripscan {
namespace {

/// A candidate that matches less than this share of the samples is no alignment.
constexpr double kLeastMatched = 0.25;
/// A rival minimum this close in score (or closer) is as good as the best one.
constexpr double kRivalMargin = 0.05;
/// Minima whose refined poses differ by more than this are different answers.
constexpr double kDifferentAnswer_rad = 1.0 * kRadPerDeg;
/// With more than this share of the samples where the other camera looked through, it is no answer:
/// right poses have next to none, sides that share nothing a tenth to a fifth.
constexpr double kMostContradicted = 0.15;
/// Starts of the second search, over all rotations, when the first one convinces nobody.
constexpr int kWideStarts = 240;

/// Steps of the polish at each scale of texture, and the motion (rad and radii) that ends them.
constexpr int kPolishSteps = 5;
constexpr double kPolished = 1e-5;
/// Errors of the surfaces that do not average out: as a share of the angle, from recordings and
/// renderings with known turns.
constexpr double kSystematicShare = 0.004;
/// Patches over which noise is taken as correlated, in radii of the part.
constexpr double kPatch = 0.3;

/// Gates of the final estimate from shape, and of everything that is measured at it.
double wide_gate_m(const Surface& source, const Surface& target) {
    return std::max(0.05 * std::max(source.radius_m, target.radius_m),
                    3.0 * std::max(source.spacing_m, target.spacing_m));
}
double narrow_gate_m(const Surface& source, const Surface& target) {
    return std::max(0.012 * std::max(source.radius_m, target.radius_m),
                    2.5 * std::max(source.spacing_m, target.spacing_m));
}

/// Shape alone, from a pose that is nearly right.
Pose refine_finely(const Surface& source, const Surface& target, const Samples& samples,
                   const Pose& start) {
    RefineSettings settings;
    settings.first_gate_m = wide_gate_m(source, target);
    settings.last_gate_m = narrow_gate_m(source, target);
    settings.shrink = 0.7;
    settings.iterations = 25;
    settings.tolerance = 1e-5;
    return refine(source, target, samples, start, settings);
}

/// Refines the best candidates with some more points and ranks them anew.
std::vector<Candidate> finals(const Surface& source, const Surface& target,
                              const DepthMap* source_map, const DepthMap* target_map,
                              std::vector<Candidate> candidates, const AlignSettings& settings,
                              const ForEach& for_each) {
    constexpr std::size_t kFinalists = 4;
    const double best = candidates.front().agreement.score;
    std::erase_if(candidates, [&](const Candidate& c) { return c.agreement.score < best - 0.25; });
    if (candidates.size() > kFinalists) candidates.resize(kFinalists);
    const auto source_sample = spread_sample(source, settings.coarse_points);
    const auto target_sample = spread_sample(target, settings.coarse_points);
    const double tolerance_m = rough_tolerance_m(source, target);
    for_each(candidates.size(), [&](std::size_t i) {
        Candidate& c = candidates[i];
        c.T_target_source =
            refine_finely(source, target, {source_sample, target_sample}, c.T_target_source);
        c.agreement = agreement(source, target, source_map, target_map, source_sample,
                                target_sample, c.T_target_source, tolerance_m);
    });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) {
                         return a.agreement.score > b.agreement.score;
                     });
    return candidates;
}

/// Shape and texture as one set of equations about the source's centre, each kind's worth divided
/// by its own correlation.
std::vector<ResidualRow> all_rows(const Surface& source, const Surface& target,
                                  const Samples& samples, const Pose& T, int scale, double gate_m) {
    const Eigen::Vector3d centre = T * source.centre_m;
    const double patch_m = kPatch * std::max(source.radius_m, target.radius_m);
    std::vector<ResidualRow> rows =
        rows_of(match(source, target, samples, T, {.gate_m = gate_m}), centre);
    std::vector<ResidualRow> texture = texture_rows(source, target, T, scale, gate_m, centre);
    for (std::vector<ResidualRow>* kind : {&rows, &texture}) {
        const double correlation = correlation_factor(*kind, patch_m);
        for (ResidualRow& row : *kind) row.information /= correlation;
    }
    rows.insert(rows.end(), texture.begin(), texture.end());
    return rows;
}

/// The last tenths of a pixel: shape and texture together, from coarse to fine texture.
Pose polish(const Surface& source, const Surface& target, const Samples& samples, Pose T,
            double gate_m) {
    if (!source.texture || !target.texture) return T;
    const double radius_m = std::max(source.radius_m, target.radius_m);
    for (int scale = kTextureScales - 1; scale >= 0; --scale) {
        for (int iteration = 0; iteration < kPolishSteps; ++iteration) {
            NormalEquations sums;
            add_rows(all_rows(source, target, samples, T, scale, gate_m), 1.0, sums);
            const Vector6d motion = -sums.H.ldlt().solve(sums.g);
            if (!motion.allFinite() || motion.head<3>().norm() > 0.1) return T;
            T = motion_about(motion, T * source.centre_m) * T;
            if (motion.head<3>().norm() + motion.tail<3>().norm() / radius_m < kPolished) break;
        }
    }
    return T;
}

double rotation_between_rad(const Pose& a, const Pose& b) {
    return rotation_angle_rad(a.linear().transpose() * b.linear());
}

}  // namespace

void judge_alone(Alignment& a, const AlignSettings& settings) {
    const double sigma_deg = deg_from_rad(a.sigma_angle_rad);
    if (a.overlap < 0.5 * kLeastMatched) {
        a.verdict = Verdict::kReject;
        a.cause = Cause::kNotConverged;
        a.sentence = fmt::format("no pose fits: only {:.0f} % of the points find a partner",
                                 100.0 * a.overlap);
    } else if (!(a.sigma_angle_rad < kLargestSigma_rad)) {
        a.verdict = Verdict::kReject;
        a.cause = Cause::kNotConverged;
        a.sentence = fmt::format("the turn is known to {:.1f} deg only", sigma_deg);
    } else if (!(a.observability >= kLeastObservability)) {
        a.verdict = Verdict::kReject;
        a.cause = Cause::kSymmetry;
        a.sentence = fmt::format(
            "the surface does not show this turn (observability {:.2f}, least {:.2f}): the part "
            "looks the same from all sides about this axis",
            a.observability, kLeastObservability);
    } else if (!a.starts_agree) {
        a.verdict = Verdict::kReject;
        a.cause = Cause::kSymmetry;
        a.sentence = "different starts end in different poses that fit equally well";
    } else if (a.overlap < settings.limits.overlap) {
        a.verdict = a.overlap < 0.5 * settings.limits.overlap ? Verdict::kReject : Verdict::kCheck;
        a.cause = Cause::kOverlap;
        a.sentence = fmt::format("overlap {:.0f} % is below the limit of {:.0f} %",
                                 100.0 * a.overlap, 100.0 * settings.limits.overlap);
    } else {
        a.verdict = Verdict::kAccept;
        a.cause = Cause::kNone;
        a.sentence = fmt::format("turn of {:.3f} deg, sigma {:.3f} deg, overlap {:.0f} %",
                                 deg_from_rad(a.angle_rad), sigma_deg, 100.0 * a.overlap);
    }
}

namespace {

/// Points of the final estimate: where texture ties the motion down, shape needs fewer beside it.
std::size_t fine_points(const Surface& source, const Surface& target,
                        const AlignSettings& settings) {
    const bool textured = source.texture && target.texture;
    return textured ? settings.fine_points / 3 : settings.fine_points;
}

Alignment measured(const Surface& source, const Surface& target, const Samples& samples,
                   const Pose& T) {
    const double radius_m = std::max(source.radius_m, target.radius_m);
    const double gate_m = narrow_gate_m(source, target);
    Alignment a;
    a.T_target_source = T;
    a.found = true;
    const auto matches = match(source, target, samples, a.T_target_source, {.gate_m = gate_m});
    const Eigen::Vector3d turn = rotation_vector(a.T_target_source.linear());
    a.angle_rad = turn.norm();
    a.centre_m = a.T_target_source * source.centre_m;
    a.covariance = motion_covariance(
        all_rows(source, target, samples, a.T_target_source, 0, gate_m), kPatch * radius_m);
    if (a.angle_rad > 1e-4) {
        a.axis = turn / a.angle_rad;
    } else {
        // No turn to speak of has no axis: judge it about the direction that is known least.
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
            a.covariance.topLeftCorner<3, 3>());
        a.axis = solver.eigenvectors().col(2);
    }
    a.sigma_angle_rad =
        std::hypot(sigma_about(a.covariance, a.axis), kSystematicShare * a.angle_rad);
    a.observability = turn_observability(source, target, matches, a.T_target_source, a.axis);
    const ResidualStatistics residuals = residual_statistics(matches);
    a.rms_m = residuals.rms_m;
    a.median_m = residuals.median_m;
    a.p90_m = residuals.p90_m;
    a.misfit = residuals.over_noise;
    a.overlap = agreement(source, target, nullptr, nullptr, samples.source, samples.target,
                          a.T_target_source, gate_m)
                    .matched;
    return a;
}

}  // namespace

Alignment finish_alignment(const Surface& source, const Surface& target, const Pose& start,
                           const AlignSettings& settings) {
    const std::size_t points = fine_points(source, target, settings);
    const auto source_fine = spread_sample(source, points);
    const auto target_fine = spread_sample(target, points);
    const Samples samples{source_fine, target_fine};
    const Pose shape = refine_finely(source, target, samples, start);
    return measured(source, target, samples,
                    polish(source, target, samples, shape, narrow_gate_m(source, target)));
}

Alignment alignment_at(const Surface& source, const Surface& target, const Pose& T_target_source,
                       const AlignSettings& settings) {
    const std::size_t points = fine_points(source, target, settings);
    const auto source_fine = spread_sample(source, points);
    const auto target_fine = spread_sample(target, points);
    return measured(source, target, {source_fine, target_fine}, T_target_source);
}

namespace {

/// Does a rival end in the same answer once it has all points and the texture? With the few points
/// of the search, starts come to rest some way up the same valley.
bool leads_to(const Pose& answer, const Surface& source, const Surface& target,
              const Candidate& rival, const AlignSettings& settings) {
    if (rotation_between_rad(rival.T_target_source, answer) <= kDifferentAnswer_rad) return true;
    const Pose settled =
        finish_alignment(source, target, rival.T_target_source, settings).T_target_source;
    return rotation_between_rad(settled, answer) <= kDifferentAnswer_rad;
}

}  // namespace

Result<Alignment> align_surfaces(const Surface& source, const Surface& target,
                                 const AlignSettings& settings, const Progress& progress,
                                 const ForEach& for_each) {
    std::optional<DepthMap> source_map;
    std::optional<DepthMap> target_map;
    if (source.viewpoint) source_map.emplace(source);
    if (target.viewpoint) target_map.emplace(target);
    const DepthMap* maps[2] = {source_map ? &*source_map : nullptr,
                               target_map ? &*target_map : nullptr};
    auto candidates = search(source, target, maps[0], maps[1], settings, settings.start_cone_rad,
                             settings.starts, for_each);
    if (settings.all_rotations || candidates.front().agreement.matched < 2.0 * kLeastMatched) {
        auto wide = search(source, target, maps[0], maps[1], settings, std::numbers::pi,
                           kWideStarts, for_each);
        if (wide.front().agreement.score > candidates.front().agreement.score + kRivalMargin) {
            candidates = std::move(wide);
        }
    }
    if (progress.cancelled()) return cancelled_error();
    auto ranked =
        finals(source, target, maps[0], maps[1], std::move(candidates), settings, for_each);
    Alignment best = finish_alignment(source, target, ranked.front().T_target_source, settings);
    const double least_score = ranked.front().agreement.score - kRivalMargin;
    best.starts_agree = true;
    for (std::size_t i = 1; i < ranked.size() && best.starts_agree; ++i) {
        best.starts_agree = ranked[i].agreement.score <= least_score ||
                            leads_to(best.T_target_source, source, target, ranked[i], settings);
    }
    judge_alone(best, settings);
    const double contradicted = ranked.front().agreement.contradicted;
    if (best.verdict != Verdict::kReject && contradicted > kMostContradicted) {
        best.verdict = Verdict::kReject;
        best.cause = Cause::kNotConverged;
        best.sentence = fmt::format(
            "no pose fits: in the best one {:.0f} % of the points would float where the other "
            "view looks through",
            100.0 * contradicted);
    }
    return best;
}

}  // namespace gripscan
