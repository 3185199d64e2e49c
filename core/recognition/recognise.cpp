#include "core/recognition/recognise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/recognition/pose_refinement.h"
#include "core/recognition/pose_voting.h"

namespace gripscan {
namespace {

constexpr std::size_t kVotedKept = 40;   ///< poses that are refined coarsely
constexpr std::size_t kCoarseKept = 10;  ///< of those, poses that are refined finely
/// Poses closer than this are one.
constexpr double kSameRotation_rad = 10.0 * kRadPerDeg;
constexpr double kSameShift = 0.06;  ///< of the diameter
/// Flat faces on larger flat ones show half to three quarters of their outline, parts that are
/// there nine tenths; a gripper goes on into the arm on one side.
constexpr double kLeastOutline = 0.78;
/// Of the surface that was measured there, the share that the camera looks through: a part that is
/// there shows edges and noise of some hundredths, another part of about its shape what it lacks.
constexpr double kMostContradicted = 0.08;
/// Share of a detection's points that a better one may own already.
constexpr double kMostShared = 0.4;

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

bool equivalent(const TemplateModel& model, const Pose& a, const Pose& b) {
    return same_pose(model, nearest_equivalent(a, model.symmetry, b), b);
}

/// The best ones that differ, best first.
template <typename Hypotheses>
Hypotheses distinct_best(const TemplateModel& model, Hypotheses all, std::size_t count) {
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
    Hypotheses kept;
    for (auto& h : all) {
        if (kept.size() == count) break;
        const bool known = std::any_of(kept.begin(), kept.end(),
                                       [&](const auto& k) { return same_pose(model, h.T, k.T); });
        if (!known) kept.push_back(std::move(h));
    }
    return kept;
}

struct Candidate {
    Pose T = Pose::Identity();
    double score = 0.0;
    Detection detection;
};

/// Recognition of one template in one view.
class Search {
  public:
    Search(const TemplateModel& model, const SceneView& scene, const ForEach& for_each)
        : model_(model), scene_(scene), for_each_(for_each), coarse_(scene.coarse(model.step_m)) {}

    [[nodiscard]] std::vector<Candidate> run() const {
        std::vector<Hypothesis> rough = rated(voted(), 1.0 * model_.step_m);
        rough = distinct_best(model_, std::move(rough), kVotedKept);
        for_each_(rough.size(), [&](std::size_t i) {
            rough[i].T = refine_coarsely(model_, coarse_, scene_.map.viewpoint(), rough[i].T);
        });
        rough = rated(std::move(rough), 0.5 * model_.step_m);
        rough = distinct_best(model_, std::move(rough), kCoarseKept);
        std::vector<Candidate> fine = finished(rough);
        fine = distinct_best(model_, std::move(fine), 6);
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
                all[i].score = a.support() * std::sqrt(a.found());
            }
        });
        return all;
    }

    [[nodiscard]] Candidate finish(const Pose& start) const {
        const double widest_m = 0.045 * model_.diameter_m;
        const FineRefinement rough =
            refine_finely(model_, scene_, start, 1.2 * model_.step_m, widest_m);
        // Within this a point counts as on the surface: by the noise of this very view and
        // template, but neither finer than the samples nor coarser than the part's own detail.
        const double tolerance_m =
            std::clamp(std::max(3.0 * rough.spread_m, 3.0 * scene_.noise_m),
                       std::min(0.012 * model_.diameter_m, widest_m), widest_m);
        const FineRefinement fine =
            refine_finely(model_, scene_, rough.T_scene_template, 1.5 * tolerance_m, tolerance_m);
        Candidate c;
        c.T = fine.T_scene_template;
        Detection& d = c.detection;
        d.name = model_.name;
        d.T_camera_template = c.T;
        d.tolerance_m = tolerance_m;
        d.agreement = full_agreement(model_, scene_, c.T, tolerance_m, &d.points);
        d.rms_m = fine.rms_m;
        d.tied_down = fine.tied_down;
        d.score = c.score = d.agreement.score();
        d.symmetry = model_.symmetry.name;
        return c;
    }

    [[nodiscard]] std::vector<Candidate> finished(const std::vector<Hypothesis>& starts) const {
        std::vector<Candidate> all(starts.size());
        for_each_(starts.size(), [&](std::size_t i) { all[i] = finish(starts[i].T); });
        return all;
    }

    /// Poses that nearly look the same are tried too: the search may have missed the better one.
    [[nodiscard]] std::vector<Candidate> with_rivals(std::vector<Candidate> all) const {
        if (all.empty() || model_.symmetry.near_turns.empty()) return all;
        std::vector<Hypothesis> rivals;
        for (const Pose& turn : model_.symmetry.near_turns) {
            rivals.push_back({all.front().T * turn, 0.0});
        }
        for (Candidate& c : finished(rivals)) all.push_back(std::move(c));
        return distinct_best(model_, std::move(all), 10);
    }

    const TemplateModel& model_;
    const SceneView& scene_;
    const ForEach& for_each_;
    CoarseScene coarse_;
};

std::size_t shared(const std::vector<std::uint32_t>& points, const std::vector<char>& owned) {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(),
                                                  [&](std::uint32_t i) { return owned[i] != 0; }));
}

bool good_enough(const Detection& d, const RecogniseSettings& settings) {
    const VisibleAgreement& a = d.agreement;
    if (a.contradicted > kMostContradicted * (a.seen + a.contradicted + a.mismatched)) return false;
    return d.agreement.outline() >= kLeastOutline && d.score >= settings.least_score &&
           d.agreement.found() >= settings.least_found;
}

/// Scene points explained, weighed by how well: what templates compete with.
double claim(const Detection& d) {
    return d.score;
}

/// The best ones first take the points they explain; who then has too few left of his own is not
/// there, or is an alternative of the one who took them.
std::vector<Detection> settle_claims(std::span<const std::shared_ptr<const TemplateModel>> models,
                                     std::vector<Detection> all, std::size_t scene_points,
                                     const RecogniseSettings& settings) {
    std::stable_sort(all.begin(), all.end(),
                     [](const Detection& a, const Detection& b) { return claim(a) > claim(b); });
    std::vector<char> owned(scene_points, 0);
    std::vector<std::size_t> count(models.size(), 0);
    std::vector<Detection> kept;
    for (Detection& d : all) {
        const auto taken = static_cast<double>(shared(d.points, owned));
        if (taken > kMostShared * static_cast<double>(d.points.size())) {
            for (Detection& k : kept) {
                if (k.template_index != d.template_index) continue;
                if (d.score < k.score - settings.alternative_margin) continue;
                if (equivalent(*models[d.template_index], d.T_camera_template,
                               k.T_camera_template)) {
                    continue;
                }
                k.alternatives.push_back({d.T_camera_template, d.score});
            }
            continue;
        }
        if (count[d.template_index] == settings.most_per_template) continue;
        ++count[d.template_index];
        for (const std::uint32_t i : d.points) owned[i] = 1;
        kept.push_back(std::move(d));
    }
    return kept;
}

}  // namespace

std::string Detection::explained() const {
    return fmt::format(
        "of the surface that should be seen {:.0f} % is, {:.0f} % is hidden, {:.0f} % is missing, "
        "{:.0f} % looks another way, {:.0f} % is not measured; {:.0f} % of the outline shows",
        100.0 * agreement.found(), 100.0 * agreement.hidden / std::max(1, agreement.visible),
        100.0 * agreement.contradicted / std::max(1, agreement.visible),
        100.0 * agreement.mismatched / std::max(1, agreement.visible),
        100.0 * agreement.unknown / std::max(1, agreement.visible), 100.0 * agreement.outline());
}

Result<std::vector<Detection>> recognise(
    std::span<const std::shared_ptr<const TemplateModel>> models, const Cloud& scene,
    const RecogniseSettings& settings, const Progress& progress, const ForEach& for_each) {
    if (models.empty()) return input_error("no templates to look for");
    double finest_m = models.front()->step_m;
    for (const auto& model : models) finest_m = std::min(finest_m, model->step_m);
    const auto view = make_scene_view(scene, finest_m, for_each);
    if (!view) return forward_error(view.error());
    std::vector<Detection> all;
    for (std::size_t m = 0; m < models.size(); ++m) {
        if (progress.cancelled()) return cancelled_error();
        progress.tell("templates", m, models.size());
        for (Candidate& c : Search(*models[m], *view, for_each).run()) {
            c.detection.template_index = m;
            if (good_enough(c.detection, settings)) all.push_back(std::move(c.detection));
        }
    }
    progress.tell("templates", models.size(), models.size());
    return settle_claims(models, std::move(all), view->points.size(), settings);
}

}  // namespace gripscan
