// Poses of a template that pairs of scene points vote for, without a starting guess: local, so that
// most of the scene may be something else.
#pragma once

#include <vector>

#include "core/base/for_each.h"
#include "core/recognition/scene_view.h"
#include "core/recognition/template_model.h"

namespace gripscan {

struct VotedPose {
    Eigen::Isometry3f T_scene_template = Eigen::Isometry3f::Identity();
    float votes = 0.0F;
};

struct VotingSettings {
    std::size_t references = 700;  ///< scene points that each find their best poses
    std::size_t partners = 350;    ///< other points that vote for one of them
    int peaks = 2;                 ///< best poses kept of each
};

/// At most `peaks` poses of every reference point, in order of the points.
[[nodiscard]] std::vector<VotedPose> vote_for_poses(const TemplateModel& model,
                                                    const CoarseScene& scene,
                                                    const VotingSettings& settings,
                                                    const ForEach& for_each);

}  // namespace gripscan
