#include "core/recognition/visible_agreement.h"

#include <algorithm>
#include <cmath>

#include "core/recognition/predicted_view.h"

namespace gripscan {
namespace {

/// Cosine of the largest angle between normals of the same spot.
constexpr float kSameNormal = 0.64F;
/// A surface that goes on across an outline does not bend by more than this (cosine).
constexpr float kSamePlane = 0.94F;
/// What a sample without any measurement speaks against a pose: stereo leaves holes.
constexpr double kUnknownShare = 0.3;

enum class Sighting { kSeen, kHidden, kContradicted, kMismatched, kUnknown };

Sighting look(const SceneView& scene, const PredictedSample& s, int column, int row,
              float tolerance) {
    if (!scene.map.inside(column, row)) return Sighting::kUnknown;
    const std::int32_t k = scene.map.point_at(column, row);
    if (k < 0) return Sighting::kUnknown;
    const auto i = static_cast<std::size_t>(k);
    const Eigen::Vector3f& normal = scene.points.normals[i];
    const float off_plane = std::abs(normal.dot(s.point - scene.points.points[i]));
    const float behind = scene.map.depth_m(i) - s.at.depth_m;
    if (off_plane <= tolerance && std::abs(behind) <= 4.0F * tolerance) {
        return normal.dot(s.normal) > kSameNormal ? Sighting::kSeen : Sighting::kMismatched;
    }
    return behind < 0.0F ? Sighting::kHidden : Sighting::kContradicted;
}

void count(Sighting sighting, VisibleAgreement& a) {
    ++a.visible;
    switch (sighting) {
        case Sighting::kSeen:
            ++a.seen;
            break;
        case Sighting::kHidden:
            ++a.hidden;
            break;
        case Sighting::kContradicted:
            ++a.contradicted;
            break;
        case Sighting::kMismatched:
            ++a.mismatched;
            break;
        case Sighting::kUnknown:
            ++a.unknown;
            break;
    }
}

/// Does the scene's surface go on beyond the outline as if there were no edge?
void judge_outline(const PredictedView& view, const SceneView& scene, float tolerance,
                   VisibleAgreement& a) {
    for (const OutlinePoint& point : view.outline) {
        const PredictedSample& s = view.samples[point.sample];
        const Eigen::Vector2f step = 2.0F * static_cast<float>(view.cell) * point.outward;
        const int column = s.at.column + static_cast<int>(std::lround(step.x()));
        const int row = s.at.row + static_cast<int>(std::lround(step.y()));
        if (!scene.map.inside(column, row)) continue;
        const std::int32_t k = scene.map.point_at(column, row);
        if (k < 0) {
            ++a.outline_open;
            continue;
        }
        const auto j = static_cast<std::size_t>(k);
        const float beyond = scene.map.depth_m(j) - s.at.depth_m;
        const float off_plane = std::abs(s.normal.dot(scene.points.points[j] - s.point));
        const bool same_plane =
            off_plane <= 2.0F * tolerance && scene.points.normals[j].dot(s.normal) > kSamePlane;
        if (same_plane) {
            ++a.outline_goes_on;
        } else if (beyond > -4.0F * tolerance) {
            ++a.outline_ends;  // else something stands in front, which says nothing
        }
    }
}

/// The scene's points on the surface that a seen sample stands for: samples are several cells
/// apart, and two poses of one part must claim the same points.
void claim_around(const SceneView& scene, const PredictedSample& s, int reach, float tolerance,
                  std::vector<std::uint32_t>& claimed) {
    for (int row = s.at.row - reach; row <= s.at.row + reach; ++row) {
        for (int column = s.at.column - reach; column <= s.at.column + reach; ++column) {
            if (!scene.map.inside(column, row)) continue;
            const std::int32_t k = scene.map.point_at(column, row);
            if (k < 0) continue;
            const auto i = static_cast<std::size_t>(k);
            if (std::abs(s.normal.dot(scene.points.points[i] - s.point)) > 2.0F * tolerance)
                continue;
            claimed.push_back(static_cast<std::uint32_t>(i));
        }
    }
}

}  // namespace

double VisibleAgreement::support() const {
    const double judged = seen + contradicted + mismatched + kUnknownShare * unknown;
    return judged > 0.0 ? seen / judged : 0.0;
}

double VisibleAgreement::found() const {
    return visible > 0 ? static_cast<double>(seen) / visible : 0.0;
}

double VisibleAgreement::outline() const {
    // Stereo measures nothing beside many edges, and a cropped scene nothing beyond its part: where
    // the scene is open it ends rather than goes on. Four undecided places are added: a pose whose
    // outline nobody can judge has shown none of it.
    constexpr double kOpenShare = 0.7;
    const double ends = outline_ends + kOpenShare * outline_open;
    return (ends + 2.0) / (ends + outline_goes_on + 4.0);
}

double VisibleAgreement::score() const {
    // A surface that goes on beyond the outline is what a flat face on a table looks like: such
    // poses have about half of their outline, right ones nearly all.
    return support() * outline() * outline() * std::sqrt(found());
}

VisibleAgreement rough_agreement(const TemplateModel& model, const SceneView& scene,
                                 const Pose& T_scene_template, double tolerance_m) {
    VisibleAgreement a;
    const auto tolerance = static_cast<float>(tolerance_m);
    for_each_visible(model.coarse, *model.coarse_seen, scene, model.centre_m, T_scene_template,
                     [&](const PredictedSample& s) {
                         count(look(scene, s, s.at.column, s.at.row, tolerance), a);
                     });
    return a;
}

VisibleAgreement full_agreement(const TemplateModel& model, const SceneView& scene,
                                const Pose& T_scene_template, double tolerance_m,
                                std::vector<std::uint32_t>* claimed) {
    VisibleAgreement a;
    const auto tolerance = static_cast<float>(tolerance_m);
    const PredictedView view = predict_view(model, scene, T_scene_template);
    for (const PredictedSample& s : view.samples) {
        const Sighting found = look(scene, s, s.at.column, s.at.row, tolerance);
        count(found, a);
        if (claimed != nullptr && found == Sighting::kSeen) {
            claim_around(scene, s, (view.cell + 1) / 2, tolerance, *claimed);
        }
    }
    judge_outline(view, scene, tolerance, a);
    if (claimed != nullptr) {
        std::sort(claimed->begin(), claimed->end());
        claimed->erase(std::unique(claimed->begin(), claimed->end()), claimed->end());
    }
    return a;
}

}  // namespace gripscan
