#include "core/recognition/template_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/units.h"
#include "core/recognition/pose_refinement.h"
#include "core/recognition/pose_voting.h"

namespace gripscan {
namespace {

constexpr std::size_t kVotedKept = 40;   ///< poses that are refined coarsely
constexpr std::size_t kCoarseKept = 24;  ///< of those, poses that are refined finely
/// Distances from the surface within which a point counts as on it, in standard deviations of the
/// scene's noise: three, with some for a template's own errors; and as much as noise that is
/// related over a matching window, and far parts of the scene, may bring.
constexpr double kNarrowest = 4.0;
constexpr double kWidest = 6.5;
/// Poses closer than this are one.
constexpr double kSameRotation_rad = 10.0 * kRadPerDeg;
constexpr double kSameShift = 0.06;  ///< of the diameter
constexpr double kSamePlace = 0.4;   ///< of the diameter, between the middles

/// Share of the best score that a pose must have to be compared with it in a duel.
constexpr double kWorthADuel = 0.75;
/// Claim of a pose that was beaten in a duel, in that of the winner.
constexpr double kBeaten = 0.999;

struct Hypothesis {
    Pose T = Pose::Identity();
    double score = 0.0;
};

bool same_pose(const TemplateModel& model, const Pose& a, const Pose& b) {
    const Pose d = a.inverse() * b;
    const Eigen::Vector3d c = model.centre_m.cast<double>();
    return rotation_angle_rad(d.linear()) < kSameRotation_rad &&
           (d * c - c).norm() < kSameShift * model.diameter_m;
}

const Pose& pose_of(const Hypothesis& h) {
    return h.T;
}
const Pose& pose_of(const PoseCandidate& c) {
    return c.T_scene_template;
}

bool same_place(const TemplateModel& model, const Pose& a, const Pose& b) {
    const Eigen::Vector3d c = model.centre_m.cast<double>();
    return (a * c - b * c).norm() < kSamePlace * model.diameter_m;
}

/// The best ones that differ, best first; not more than per_place about the same place, lest one
/// thing that looks alike takes all.
template <typename Hypotheses>
Hypotheses distinct_best(const TemplateModel& model, Hypotheses all, std::size_t count,
                         std::ptrdiff_t per_place) {
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
    Hypotheses kept;
    for (auto& h : all) {
        if (kept.size() == count) break;
        const bool known = std::any_of(kept.begin(), kept.end(), [&](const auto& k) {
            return same_pose(model, pose_of(h), pose_of(k));
        });
        if (known) continue;
        const auto here = std::count_if(kept.begin(), kept.end(), [&](const auto& k) {
            return same_place(model, pose_of(h), pose_of(k));
        });
        if (here < per_place) kept.push_back(std::move(h));
    }
    return kept;
}

/// What speaks against a rough pose is mostly its roughness: all counts alike.
double rough_score(const VisibleAgreement& a) {
    const double judged = a.seen + a.contradicted + a.mismatched + 0.3 * a.unknown;
    return judged > 0.0 ? a.seen / judged * std::sqrt(a.found()) : 0.0;
}

/// A flat face, or two, fits many things. Where the surface found does not tie the part down, its
/// outline has to: not only on one side.
double shape_shown(const VisibleAgreement& a, double tied_down) {
    constexpr double kTiedDown = 0.012;
    constexpr double kEnoughOutline = 0.3;
    // The outline of a compact shape is about four times the root of its area.
    const double all_around =
        4.0 * std::sqrt(std::max(1.0, static_cast<double>(a.visible - a.hidden)));
    return std::min(1.0, tied_down / kTiedDown +
                             (a.outline_ends + a.outline_open) / (kEnoughOutline * all_around));
}

/// A part that is there is met to the noise of the view, with something for the template's own
/// errors; what merely looks alike is met worse.
double fit_quality(const SceneView& scene, double rms_m) {
    if (scene.noise_m <= 0.0) return 1.0;
    // Neighbours of a depth image that does not tell its noise err together: it is more than they
    // differ by.
    const double as_good_as_noise = scene.noise_told ? 2.0 : 3.0;
    const double worse = std::max(0.0, rms_m / scene.noise_m - as_good_as_noise);
    return scene.noise_told ? std::pow(1.0 + worse * worse, -2.5)
                            : 1.0 / (1.0 + 0.5 * worse * worse);
}

/// Recognition of one template in one view.
class Search {
  public:
    Search(const TemplateModel& model, const SceneView& scene, const ForEach& for_each)
        : model_(model), scene_(scene), for_each_(for_each), coarse_(scene.coarse(model.step_m)) {}

    [[nodiscard]] std::vector<PoseCandidate> run() const {
        std::vector<Hypothesis> rough = rated(voted(), 1.0 * model_.step_m);
        rough = distinct_best(model_, std::move(rough), kVotedKept, 8);
        for_each_(rough.size(), [&](std::size_t i) {
            rough[i].T = refine_coarsely(model_, coarse_, scene_.map.viewpoint(), rough[i].T);
        });
        rough = rated(std::move(rough), 0.5 * model_.step_m);
        rough = distinct_best(model_, std::move(rough), kCoarseKept, 4);
        std::vector<PoseCandidate> fine = finished(rough);
        fine = distinct_best(model_, std::move(fine), 6, 6);
        return with_rivals(std::move(fine));
    }

  private:
    [[nodiscard]] std::vector<Hypothesis> voted() const {
        std::vector<Hypothesis> all;
        for (const VotedPose& v : vote_for_poses(model_, coarse_, {}, for_each_)) {
            all.push_back({v.T_scene_template.cast<double>(), 0.0});
        }
        return all;
    }

    [[nodiscard]] std::vector<Hypothesis> rated(std::vector<Hypothesis> all,
                                                double tolerance_m) const {
        constexpr std::size_t kBlock = 64;
        for_each_((all.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
            for (std::size_t i = block * kBlock; i < std::min(all.size(), (block + 1) * kBlock);
                 ++i) {
                const auto a = rough_agreement(model_, scene_, all[i].T, tolerance_m);
                all[i].score = rough_score(a);
            }
        });
        return all;
    }

    [[nodiscard]] std::vector<PoseCandidate> finished(const std::vector<Hypothesis>& starts) const {
        std::vector<PoseCandidate> all(starts.size());
        for_each_(starts.size(),
                  [&](std::size_t i) { all[i] = refined_candidate(model_, scene_, starts[i].T); });
        return all;
    }

    /// Poses that nearly look the same are tried too, for the search may have missed the better
    /// one; those that the difference itself speaks against are no alternatives.
    [[nodiscard]] std::vector<PoseCandidate> with_rivals(std::vector<PoseCandidate> all) const {
        if (all.empty() || model_.symmetry.near_turns.empty()) return all;
        std::vector<Hypothesis> rivals;
        for (const Pose& turn : model_.symmetry.near_turns) {
            rivals.push_back({all.front().T_scene_template * turn, 0.0});
        }
        for (PoseCandidate& c : finished(rivals)) all.push_back(std::move(c));
        all = distinct_best(model_, std::move(all), 10, 10);
        const Champion found = champion_of(all);
        PoseCandidate& champion = all[found.index];
        // What speaks for the part being there speaks for each of the poses.
        for (const PoseCandidate& c : all) {
            if (turn_between(champion, c)) champion.score = std::max(champion.score, c.score);
        }
        champion.claim = champion.score * static_cast<double>(champion.points.size());
        std::vector<PoseCandidate> left;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto turn = i == found.index ? std::nullopt : turn_between(champion, all[i]);
            if (turn) {
                const Duel d = found.duels[i] ? *found.duels[i] : compared(champion, all[i], *turn);
                if (d.first > d.second && d.decisive()) continue;
                all[i].claim = std::min(all[i].claim, kBeaten * champion.claim);
            }
            left.push_back(all[i]);
        }
        return left;
    }

    /// The near symmetry that takes one to the other.
    [[nodiscard]] std::optional<Pose> turn_between(const PoseCandidate& a,
                                                   const PoseCandidate& b) const {
        for (const Pose& turn : model_.symmetry.near_turns) {
            if (same_pose(model_, a.T_scene_template * turn, b.T_scene_template)) return turn;
        }
        return std::nullopt;
    }

    /// Each pose against its own turned copy: so that only what the turn changes differs, and not
    /// what the two were refined to.
    [[nodiscard]] Duel compared(const PoseCandidate& a, const PoseCandidate& b,
                                const Pose& turn) const {
        const double tolerance_m = std::min(a.tolerance_m, b.tolerance_m);
        const Duel one =
            duel(model_, scene_, a.T_scene_template, a.T_scene_template * turn, tolerance_m);
        const Duel other = duel(model_, scene_, b.T_scene_template * turn.inverse(),
                                b.T_scene_template, tolerance_m);
        return {(one.first + other.first) / 2, (one.second + other.second) / 2};
    }

    struct Champion {
        std::size_t index = 0;
        std::vector<std::optional<Duel>> duels;  ///< its own, with those it has met
    };
    [[nodiscard]] Champion champion_of(const std::vector<PoseCandidate>& all) const {
        Champion best{0, std::vector<std::optional<Duel>>(all.size())};
        for (std::size_t i = 1; i < all.size(); ++i) {
            const auto turn = turn_between(all[best.index], all[i]);
            if (!turn) continue;
            const Duel d = compared(all[best.index], all[i], *turn);
            const bool as_good = all[i].score > kWorthADuel * all[best.index].score;
            if (d.second > d.first && (as_good || d.decisive())) {
                best = {i, std::vector<std::optional<Duel>>(all.size())};
            } else {
                best.duels[i] = d;
            }
        }
        return best;
    }

    const TemplateModel& model_;
    const SceneView& scene_;
    const ForEach& for_each_;
    CoarseScene coarse_;
};

}  // namespace

PoseCandidate refined_candidate(const TemplateModel& model, const SceneView& scene,
                                const Pose& start) {
    // What fits worse than the noise of the view allows is not the part; but clouds that do not
    // know their noise, and templates, have errors of their own.
    const double widest_m = scene.noise_told
                                ? std::clamp(kWidest * scene.noise_m, 0.012 * model.diameter_m,
                                             0.045 * model.diameter_m)
                                : 0.03 * model.diameter_m;
    const FineRefinement rough = refine_finely(model, scene, start, 1.2 * model.step_m, widest_m);
    PoseCandidate c;
    c.tolerance_m =
        std::clamp(3.0 * rough.spread_m, std::min(kNarrowest * scene.noise_m, widest_m), widest_m);
    const FineRefinement fine =
        refine_finely(model, scene, rough.T_scene_template, 1.5 * c.tolerance_m, c.tolerance_m);
    c.T_scene_template = fine.T_scene_template;
    c.agreement = full_agreement(model, scene, c.T_scene_template, c.tolerance_m, &c.points);
    c.rms_m = fine.rms_m;
    c.tied_down = fine.tied_down;
    c.score =
        c.agreement.score() * shape_shown(c.agreement, c.tied_down) * fit_quality(scene, c.rms_m);
    c.claim = c.score * static_cast<double>(c.points.size());
    return c;
}

std::vector<PoseCandidate> search_template(const TemplateModel& model, const SceneView& scene,
                                           const ForEach& for_each) {
    return Search(model, scene, for_each).run();
}

bool equivalent_poses(const TemplateModel& model, const Pose& a, const Pose& b) {
    return same_pose(model, nearest_equivalent(a, model.symmetry, b), b);
}

}  // namespace gripscan
