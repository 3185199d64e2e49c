#include "core/registration/joint_solution.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "core/registration/joint_system.h"
#include "core/registration/point_to_plane.h"
#include "core/registration/texture_rows.h"

namespace gripscan {
namespace {

/// Small systematic errors of the surfaces turn every angle between views by the same factor, which
/// looks like a ratio of the robot's; only a turn that closes can tell the two apart.
constexpr double kScanScaleSigma = 5e-3;
/// Gauss–Newton steps on one set of correspondences.
constexpr int kSteps = 2;
/// However many rows a pair has, its motion is not known better than this: errors of the surfaces
/// that go with the camera do not average out.
constexpr double kPairSigma_rad = 6e-4;
constexpr double kPairSigma_m = 3e-5;
/// The scale is never known better than this: texture and shape are no perfect witnesses.
constexpr double kScaleFloor = 3e-4;
/// How far the data may pull the scale before it is looked at: wide, so that a wrong gear ratio
/// shows itself.
constexpr double kScalePrior = 0.05;

/// Patches over which noise is taken as correlated, in radii of the part.
constexpr double kPatch = 0.3;
/// Views further apart than this see the same texture too differently.
constexpr double kTextureReach_rad = 0.8;

struct Pair {
    std::size_t from = 0;
    std::size_t to = 0;
    bool closing = false;  ///< the long way round
};

double wrapped(double angle_rad) {
    return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

/// Each view with its nearest neighbours in angle, once a pair.
std::vector<Pair> pairs_of(std::span<const JointView> views, const JointSettings& settings) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < views.size(); ++i) {
        std::vector<std::pair<double, std::size_t>> ahead;
        for (std::size_t j = 0; j < views.size(); ++j) {
            if (j == i) continue;
            const double d = wrapped(views[j].angle_rad - views[i].angle_rad);
            const bool forward = d > 0.0 || (d == 0.0 && j > i);
            if (forward && d < settings.reach_rad) ahead.emplace_back(d, j);
        }
        std::sort(ahead.begin(), ahead.end());
        if (ahead.size() > static_cast<std::size_t>(settings.neighbours)) {
            ahead.resize(static_cast<std::size_t>(settings.neighbours));
        }
        for (const auto& [d, j] : ahead) {
            const double direct = std::abs(views[j].angle_rad - views[i].angle_rad);
            pairs.push_back({i, j, direct > d + 0.1});
        }
    }
    return pairs;
}

/// What a pair of views says near the relative pose it was measured at.
struct PairTerm {
    Pose T_to_from = Pose::Identity();
    NormalEquations sums;
    std::size_t matches = 0;
};

struct State {
    Axis axis;
    std::vector<Pose> T_view_first;
    double scale = 1.0;
    double offset_rad = 0.0;
    double scan_scale = 1.0;
    double scale_sigma = 0.0;
    std::array<double, 2> axis_sigma{};  ///< rad, m
};

/// One round of correspondences.
struct Round {
    double gate = 0.0;  ///< in radii of the part
    bool closing = false;
    std::optional<int> texture_scale;
};

class Solver {
  public:
    Solver(std::span<const JointView> views, const Axis& axis, const JointSettings& settings,
           const ForEach& for_each)
        : views_(views),
          settings_(settings),
          for_each_(for_each),
          pairs_(pairs_of(views, settings)),
          samples_(views.size()) {
        for_each_(views.size(), [&](std::size_t k) {
            samples_[k] = spread_sample(*views_[k].surface, settings_.points);
        });
        for (const JointView& view : views_) {
            centre_ += view.surface->centre_m / static_cast<double>(views_.size());
            radius_m_ = std::max(radius_m_, view.surface->radius_m);
            spacing_m_ = std::max(spacing_m_, view.surface->spacing_m);
        }
        centre_ = axis.nearest_to(centre_);
    }

    [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }

    /// Correspondences of all pairs at the present poses.
    [[nodiscard]] std::vector<PairTerm> measure(const State& state, const Round& round) const {
        std::vector<PairTerm> terms(pairs_.size());
        for_each_(pairs_.size(), [&](std::size_t i) {
            if (pairs_[i].closing && !round.closing) return;
            terms[i] = term(pairs_[i], state, round);
        });
        return terms;
    }

    /// One Gauss–Newton step on what was measured, moved on to the present poses.
    void improve(State& state, const std::vector<PairTerm>& terms, bool free_scale) const {
        JointSystem system(views_.size(), state.axis, centre_);
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            if (terms[i].matches < 100) continue;
            const Pose T =
                state.T_view_first[pairs_[i].to] * state.T_view_first[pairs_[i].from].inverse();
            NormalEquations sums = terms[i].sums;
            sums.g += sums.H * motion_of(T * terms[i].T_to_from.inverse(), centre_);
            // Each view takes part in several pairs with the same noise.
            system.add_pair(pairs_[i].from, pairs_[i].to, T, apart_rad(pairs_[i]), state.scan_scale,
                            sums, 1.0 / settings_.neighbours);
        }
        for (std::size_t k = 1; k < views_.size(); ++k) {
            system.add_prior(k, state.T_view_first[k], state.scale, state.offset_rad,
                             {views_[k].angle_rad, views_[k].sigma_rad,
                              settings_.sigma_off_axis_rad, settings_.sigma_shift_m});
        }
        system.add_global_prior(JointSystem::kRobotScale, 1.0 - state.scale,
                                free_scale ? kScalePrior : 1e-9);
        system.add_global_prior(JointSystem::kRobotOffset, -state.offset_rad,
                                views_.front().sigma_rad);
        system.add_global_prior(JointSystem::kScanScale, 1.0 - state.scan_scale, kScanScaleSigma);
        if (!system.solve()) return;
        for (std::size_t k = 1; k < views_.size(); ++k) {
            state.T_view_first[k] = system.correction(k) * state.T_view_first[k];
        }
        const auto globals = system.global_corrections();
        const auto sigmas = system.global_sigmas();
        state.axis = system.corrected_axis();
        state.scale += globals(JointSystem::kRobotScale);
        state.offset_rad += globals(JointSystem::kRobotOffset);
        state.scan_scale += globals(JointSystem::kScanScale);
        state.scale_sigma = sigmas(JointSystem::kRobotScale);
        state.axis_sigma = {std::hypot(sigmas(0), sigmas(1)) / std::numbers::sqrt2,
                            std::hypot(sigmas(2), sigmas(3)) / std::numbers::sqrt2};
    }

    [[nodiscard]] double gate_m(double share) const {
        return std::max(share * radius_m_, 2.5 * spacing_m_);
    }

  private:
    [[nodiscard]] double apart_rad(const Pair& pair) const {
        return wrapped(views_[pair.to].angle_rad - views_[pair.from].angle_rad);
    }

    [[nodiscard]] PairTerm term(const Pair& pair, const State& state, const Round& round) const {
        PairTerm result;
        result.T_to_from = state.T_view_first[pair.to] * state.T_view_first[pair.from].inverse();
        const Surface& from = *views_[pair.from].surface;
        const Surface& to = *views_[pair.to].surface;
        const double gate = gate_m(round.gate);
        const auto matches = match(from, to, {samples_[pair.from], samples_[pair.to]},
                                   result.T_to_from, {.gate_m = gate});
        result.matches = matches.size();
        const double patch_m = kPatch * radius_m_;
        const auto shape = rows_of(matches, centre_);
        add_rows(shape, correlation_factor(shape, patch_m), result.sums);
        if (round.texture_scale && std::abs(apart_rad(pair)) < kTextureReach_rad) {
            const auto texture =
                texture_rows(from, to, result.T_to_from, *round.texture_scale, gate, centre_);
            add_rows(texture, correlation_factor(texture, patch_m), result.sums);
        }
        limit_knowledge(result.sums);
        return result;
    }

    /// Adds the systematic part to what the rows say: (H⁻¹ + S)⁻¹ in place of H.
    static void limit_knowledge(NormalEquations& sums) {
        Vector6d systematic;
        systematic << Eigen::Vector3d::Constant(kPairSigma_rad * kPairSigma_rad),
            Eigen::Vector3d::Constant(kPairSigma_m * kPairSigma_m);
        const Matrix6d A = Matrix6d::Identity() + sums.H * systematic.asDiagonal();
        const Eigen::PartialPivLU<Matrix6d> lu(A);
        sums.H = lu.solve(sums.H);
        sums.H = 0.5 * (sums.H + sums.H.transpose().eval());
        sums.g = lu.solve(sums.g);
    }

    std::span<const JointView> views_;
    const JointSettings& settings_;
    const ForEach& for_each_;
    std::vector<Pair> pairs_;
    std::vector<std::vector<std::uint32_t>> samples_;
    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
    double radius_m_ = 0.0;
    double spacing_m_ = 0.0;
};

}  // namespace

Result<JointSolution> solve_jointly(std::span<const JointView> views, const Axis& start,
                                    const JointSettings& settings, const Progress& progress,
                                    const ForEach& for_each) {
    const Solver solver(views, start, settings, for_each);
    State state;
    state.axis = start;
    for (const JointView& view : views) {
        state.T_view_first.push_back(turn_about(start, view.angle_rad));
    }
    // First shape alone and among neighbours; the closing pairs join when the chain is good enough
    // to bring them together, texture when the poses are within its reach.
    const std::array<Round, 4> rounds{{{0.05, false, std::nullopt},
                                       {0.025, true, std::nullopt},
                                       {0.012, true, 1},
                                       {0.012, true, 0}}};
    std::vector<PairTerm> terms;
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        if (progress.cancelled()) return cancelled_error();
        progress.tell("joint solution", i, rounds.size() + 1);
        terms = solver.measure(state, rounds[i]);
        for (int step = 0; step < kSteps; ++step) {
            solver.improve(state, terms, !settings.scale_known);
        }
    }
    JointSolution solution;
    solution.scale_sigma = std::max(state.scale_sigma, kScaleFloor);
    solution.scale_estimated =
        !settings.scale_known && std::abs(state.scale - 1.0) > 3.0 * solution.scale_sigma;
    if (!solution.scale_estimated) state.scale = 1.0;
    // Once more where the poses have come to.
    for (int step = 0; step < kSteps; ++step) {
        solver.improve(state, terms, solution.scale_estimated);
    }
    if (progress.cancelled()) return cancelled_error();
    progress.tell("joint solution", rounds.size(), rounds.size() + 1);
    terms = solver.measure(state, rounds.back());
    for (int step = 0; step < kSteps; ++step) {
        solver.improve(state, terms, solution.scale_estimated);
    }
    solution.scale = state.scale;
    solution.T_view_first = std::move(state.T_view_first);
    solution.axis = {state.axis, state.axis_sigma[0], state.axis_sigma[1]};
    solution.axis.axis.point_m = state.axis.nearest_to(solver.centre());
    return solution;
}

}  // namespace gripscan
