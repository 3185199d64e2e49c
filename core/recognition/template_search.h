// Poses of one template that a view may show, each refined and judged by itself.
#pragma once

#include <vector>

#include "core/base/for_each.h"
#include "core/recognition/scene_view.h"
#include "core/recognition/template_model.h"
#include "core/recognition/visible_agreement.h"

namespace gripscan {

/// A refined pose and what speaks for and against it.
struct PoseCandidate {
    Pose T_scene_template = Pose::Identity();
    double score = 0.0;
    /// What poses compete with for the points of the scene: how many they explain, and how well. By
    /// the score alone a box would win the body of a gripper from the gripper.
    double claim = 0.0;
    VisibleAgreement agreement;
    double rms_m = 0.0;                 ///< of the points on the surface, along the normal
    double tied_down = 0.0;             ///< 0: some motion of the part would not be noticed
    double tolerance_m = 0.0;           ///< within which a point counts as on the surface
    std::vector<std::uint32_t> points;  ///< of the scene, that lie on the predicted surface
};

/// Refined as far as the view's noise allows, and judged.
[[nodiscard]] PoseCandidate refined_candidate(const TemplateModel& model, const SceneView& scene,
                                              const Pose& start);

/// The best poses that differ, best first; none of them need be right.
[[nodiscard]] std::vector<PoseCandidate> search_template(const TemplateModel& model,
                                                         const SceneView& scene,
                                                         const ForEach& for_each);

/// The two show the part at the same place and look alike there.
[[nodiscard]] bool equivalent_poses(const TemplateModel& model, const Pose& a, const Pose& b);

}  // namespace gripscan
