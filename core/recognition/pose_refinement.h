// From a rough pose of a template in a view to one as good as the noise allows.
#pragma once

#include <span>

#include "core/geometry/pose.h"
#include "core/recognition/scene_view.h"
#include "core/recognition/template_model.h"

namespace gripscan {

/// Gauss–Newton on distances along common normals, partners by nearest neighbour among coarse
/// points: pulls from about three steps away.
[[nodiscard]] Pose refine_coarsely(const TemplateModel& model, const CoarseScene& scene,
                                   const Eigen::Vector3f& viewpoint, const Pose& start);

struct FineRefinement {
    Pose T_scene_template = Pose::Identity();
    double rms_m = 0.0;     ///< of the partners, along their normals, outliers left out
    double spread_m = 0.0;  ///< robust standard deviation (from the median) of all partners
    /// Smallest over largest eigenvalue of the equations, lengths in units of the part's radius:
    /// how well the least known direction is tied down.
    double tied_down = 0.0;
};

/// The same with partners by line of sight at full resolution, the gate narrowing from first_gate_m
/// to last_gate_m.
[[nodiscard]] FineRefinement refine_finely(const TemplateModel& model, const SceneView& scene,
                                           const Pose& start, double first_gate_m,
                                           double last_gate_m);

/// The same of the template onto itself (or onto a part of it), partners by nearest neighbour among
/// dense points: for symmetries.
[[nodiscard]] Pose refine_onto(const OrientedPoints& moving, const OrientedPoints& still,
                               const KdTree& still_tree, const Pose& start, double first_gate_m,
                               double last_gate_m);

}  // namespace gripscan
