#include "core/registration/joint_solution.h"

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

/// A ratio may differ from 1 by this without being a fault of the robot: small systematic errors
/// of the surfaces look like it.
constexpr double kScaleSystematic = 7e-4;
/// How far the data may pull the scale before it is looked at: wide, so that a wrong gear ratio
/// shows itself.
constexpr double kScalePrior = 0.05;

/// Patches over which noise is taken as correlated, in radii of the part.
constexpr double kPatch = 0.3;
/// Views further apart than this see the same texture too differently.
constexpr double kTextureReach_rad = 0.45;

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

struct PairTerm {
    NormalEquations sums;
    std::size_t matches = 0;
};

struct State {
    Axis axis;
    std::vector<Pose> T_view_first;
    double scale = 1.0;
    double offset_rad = 0.0;
    double scale_sigma = 0.0;
    std::array<double, 2> axis_sigma{};  ///< rad, m
};

class Solver {
  public:
    Solver(std::span<const JointView> views, const JointSettings& settings, const ForEach& for_each)
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
    }

    [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }

    /// One round: correspondences, system, correction.
    void improve(State& state, int scale, double gate_m, bool closing, bool free_scale) const {
        std::vector<PairTerm> terms(pairs_.size());
        for_each_(pairs_.size(), [&](std::size_t i) {
            if (pairs_[i].closing && !closing) return;
            terms[i] = term(pairs_[i], state, scale, gate_m);
        });
        JointSystem system(views_.size(), state.axis, state.axis.nearest_to(centre_));
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            if (terms[i].matches < 100) continue;
            const Pose T =
                state.T_view_first[pairs_[i].to] * state.T_view_first[pairs_[i].from].inverse();
            // Each view takes part in several pairs with the same noise.
            const double weight = 1.0 / settings_.neighbours;
            system.add_pair(pairs_[i].from, pairs_[i].to, T, terms[i].sums, weight);
        }
        for (std::size_t k = 1; k < views_.size(); ++k) {
            system.add_prior(k, state.T_view_first[k], state.scale, state.offset_rad,
                             {views_[k].angle_rad, views_[k].sigma_rad,
                              settings_.sigma_off_axis_rad, settings_.sigma_shift_m});
        }
        system.add_global_prior(4, 1.0 - state.scale, free_scale ? kScalePrior : 1e-9);
        system.add_global_prior(5, -state.offset_rad, views_.front().sigma_rad);
        if (!system.solve()) return;
        for (std::size_t k = 1; k < views_.size(); ++k) {
            state.T_view_first[k] = system.correction(k) * state.T_view_first[k];
        }
        const auto globals = system.global_corrections();
        const auto sigmas = system.global_sigmas();
        state.axis = system.corrected_axis();
        state.scale += globals(4);
        state.offset_rad += globals(5);
        state.scale_sigma = sigmas(4);
        state.axis_sigma = {std::hypot(sigmas(0), sigmas(1)) / std::numbers::sqrt2,
                            std::hypot(sigmas(2), sigmas(3)) / std::numbers::sqrt2};
    }

    [[nodiscard]] double gate_m(double share) const {
        return std::max(share * radius_m_, 2.5 * spacing_m_);
    }

  private:
    [[nodiscard]] PairTerm term(const Pair& pair, const State& state, int scale,
                                double gate_m) const {
        // Relative motion about the same centre as the system uses.
        const Pose T = state.T_view_first[pair.to] * state.T_view_first[pair.from].inverse();
        const auto matches = match(*views_[pair.from].surface, *views_[pair.to].surface,
                                   {samples_[pair.from], samples_[pair.to]}, T, {.gate_m = gate_m});
        PairTerm result;
        result.matches = matches.size();
        const Eigen::Vector3d centre = state.axis.nearest_to(centre_);
        const double patch_m = kPatch * radius_m_;
        const auto shape = rows_of(matches, centre);
        add_rows(shape, correlation_factor(shape, patch_m), result.sums);
        const double apart =
            std::abs(wrapped(views_[pair.to].angle_rad - views_[pair.from].angle_rad));
        if (apart < kTextureReach_rad) {
            const auto texture = texture_rows(*views_[pair.from].surface, *views_[pair.to].surface,
                                              T, scale, gate_m, centre);
            add_rows(texture, correlation_factor(texture, patch_m), result.sums);
        }
        return result;
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
    const Solver solver(views, settings, for_each);
    State state;
    state.axis = start;
    for (const JointView& view : views) {
        state.T_view_first.push_back(turn_about(start, view.angle_rad));
    }
    // First among neighbours only and with a free scale; the closing pairs join when the chain
    // is good enough to bring them together.
    const int half = settings.rounds / 2;
    for (int round = 0; round < settings.rounds; ++round) {
        if (progress.cancelled()) return cancelled_error();
        progress.tell("joint solution", static_cast<std::size_t>(round),
                      static_cast<std::size_t>(settings.rounds + half));
        solver.improve(state, std::clamp(half - 1 - round, 0, kTextureScales - 1),
                       solver.gate_m(0.05 * std::pow(0.75, round)), round >= half, true);
    }
    JointSolution solution;
    solution.scale_sigma = std::hypot(state.scale_sigma, kScaleSystematic);
    solution.scale_estimated = std::abs(state.scale - 1.0) > 3.0 * solution.scale_sigma;
    if (!solution.scale_estimated) {
        state.scale = 1.0;
        for (int round = 0; round < half; ++round) {
            if (progress.cancelled()) return cancelled_error();
            progress.tell("joint solution", static_cast<std::size_t>(settings.rounds + round),
                          static_cast<std::size_t>(settings.rounds + half));
            solver.improve(state, 0, solver.gate_m(0.012), true, false);
        }
    }
    solution.scale = state.scale;
    solution.T_view_first = std::move(state.T_view_first);
    solution.axis = {state.axis, state.axis_sigma[0], state.axis_sigma[1]};
    solution.axis.axis.point_m = state.axis.nearest_to(solver.centre());
    return solution;
}

}  // namespace gripscan
