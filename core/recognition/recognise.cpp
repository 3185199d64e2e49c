#include "core/recognition/recognise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/recognition/template_search.h"

namespace gripscan {
namespace {

/// Fewer cells than this show no shape.
constexpr int kFewestSeen = 150;
/// Share of a detection's points that a better one may own already.
constexpr double kMostShared = 0.4;

std::size_t shared(const std::vector<std::uint32_t>& points, const std::vector<char>& owned) {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(),
                                                  [&](std::uint32_t i) { return owned[i] != 0; }));
}

bool good_enough(const PoseCandidate& d, const RecogniseSettings& settings) {
    const VisibleAgreement& a = d.agreement;
    return a.seen >= kFewestSeen && a.found() >= settings.least_found &&
           a.outline() >= a.weights->least_outline && d.score >= settings.least_score;
}

struct Claimant {
    Detection detection;
    double claim = 0.0;
};

/// The best ones first take the points they explain; who then has too few left of his own is not
/// there, or is an alternative of the one who took them.
std::vector<Detection> settle_claims(std::span<const std::shared_ptr<const TemplateModel>> models,
                                     std::vector<Claimant> all, std::size_t scene_points,
                                     const RecogniseSettings& settings) {
    std::stable_sort(all.begin(), all.end(),
                     [](const Claimant& a, const Claimant& b) { return a.claim > b.claim; });
    std::vector<char> owned(scene_points, 0);
    std::vector<std::size_t> count(models.size(), 0);
    std::vector<Detection> kept;
    for (Claimant& claimant : all) {
        Detection& d = claimant.detection;
        const auto taken = static_cast<double>(shared(d.points, owned));
        if (taken > kMostShared * static_cast<double>(d.points.size())) {
            for (Detection& k : kept) {
                if (k.template_index != d.template_index) continue;
                if (d.score < k.score - settings.alternative_margin) continue;
                if (equivalent_poses(*models[d.template_index], d.T_camera_template,
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
    std::vector<Claimant> all;
    for (std::size_t m = 0; m < models.size(); ++m) {
        if (progress.cancelled()) return cancelled_error();
        progress.tell("templates", m, models.size());
        for (PoseCandidate& c : search_template(*models[m], *view, for_each)) {
            if (!good_enough(c, settings)) continue;
            Detection d;
            d.name = models[m]->name;
            d.template_index = m;
            d.T_camera_template = c.T_scene_template;
            d.score = c.score;
            d.agreement = c.agreement;
            d.rms_m = c.rms_m;
            d.tied_down = c.tied_down;
            d.tolerance_m = c.tolerance_m;
            d.symmetry = models[m]->symmetry.name;
            d.points = std::move(c.points);
            all.push_back({std::move(d), c.claim});
        }
    }
    progress.tell("templates", models.size(), models.size());
    return settle_claims(models, std::move(all), view->points.size(), settings);
}

}  // namespace gripscan
