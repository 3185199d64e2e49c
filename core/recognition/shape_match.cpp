#include "core/recognition/shape_match.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/recognition/pose_refinement.h"
#include "core/recognition/pose_voting.h"
#include "core/recognition/template_model.h"

namespace gripscan {
namespace {

constexpr double kSameTurn_rad = 12.0 * kRadPerDeg;
constexpr std::size_t kMostCandidates = 60;

std::vector<ShapeMatch> distinct(std::vector<ShapeMatch> all) {
    std::stable_sort(all.begin(), all.end(),
                     [](const ShapeMatch& a, const ShapeMatch& b) { return a.same > b.same; });
    std::vector<ShapeMatch> kept;
    for (const ShapeMatch& m : all) {
        const bool known = std::any_of(kept.begin(), kept.end(), [&](const ShapeMatch& k) {
            return rotation_angle_rad(k.T_still_moving.linear().transpose() *
                                      m.T_still_moving.linear()) < kSameTurn_rad;
        });
        if (!known) kept.push_back(m);
    }
    return kept;
}

}  // namespace

ShapeMatcher::ShapeMatcher(const TemplateModel& still)
    : still_(still),
      tree_(still.dense.points),
      tolerance_m_(std::max(0.012 * still.diameter_m, 1.5 * still.spacing_m)) {}

double ShapeMatcher::same(const TemplateModel& moving, const Pose& T) const {
    const Eigen::Matrix3f R = T.linear().cast<float>();
    const Eigen::Vector3f t = T.translation().cast<float>();
    std::size_t on_it = 0;
    for (std::size_t i = 0; i < moving.samples.size(); ++i) {
        const Eigen::Vector3f p = R * moving.samples.points[i] + t;
        const auto found = tree_.nearest_within(p, static_cast<float>(2.0 * tolerance_m_));
        if (!found) continue;
        const Eigen::Vector3f& n = still_.dense.normals[found->index];
        const float off = std::abs(n.dot(p - still_.dense.points[found->index]));
        if (off < static_cast<float>(tolerance_m_) && n.dot(R * moving.samples.normals[i]) > 0.5F) {
            ++on_it;
        }
    }
    return static_cast<double>(on_it) / static_cast<double>(moving.samples.size());
}

ShapeMatch ShapeMatcher::settled(const TemplateModel& moving, const Pose& start) const {
    const Pose coarse =
        refine_onto(moving.coarse, still_.dense, tree_, start, 2.0 * moving.step_m, moving.step_m);
    const Pose fine =
        refine_onto(moving.coarse, still_.dense, tree_, coarse, moving.step_m, tolerance_m_);
    return {fine, same(moving, fine)};
}

std::vector<ShapeMatch> ShapeMatcher::search(const TemplateModel& moving, double least_same,
                                             const ForEach& for_each) const {
    CoarseScene scene;
    scene.points = still_.coarse;
    scene.tree = KdTree(still_.coarse.points);
    const auto voted =
        vote_for_poses(moving, scene, {.references = 250, .partners = 350, .peaks = 12}, for_each);
    std::vector<ShapeMatch> starts;
    for (const VotedPose& v : voted) {
        starts.push_back({v.T_scene_template.cast<double>(), static_cast<double>(v.votes)});
    }
    starts = distinct(std::move(starts));  // by votes
    if (starts.size() > kMostCandidates) starts.resize(kMostCandidates);
    std::vector<ShapeMatch> ends(starts.size());
    for_each(starts.size(),
             [&](std::size_t i) { ends[i] = settled(moving, starts[i].T_still_moving); });
    std::erase_if(ends, [&](const ShapeMatch& m) { return m.same < least_same; });
    return distinct(std::move(ends));
}

}  // namespace gripscan
