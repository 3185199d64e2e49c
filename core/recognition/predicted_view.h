// What the camera would see of a template at a pose: the visible samples, and the outline beyond
// which there is nothing of the part.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/pose.h"
#include "core/recognition/scene_view.h"
#include "core/recognition/template_model.h"

namespace gripscan {

struct PredictedSample {
    Eigen::Vector3f point;  ///< scene frame, m
    Eigen::Vector3f normal;
    ViewMap::Place at;
};

/// A sample next to the outline, and which way is out in the map.
struct OutlinePoint {
    std::size_t sample = 0;
    Eigen::Vector2f outward = Eigen::Vector2f::Zero();  ///< unit, columns and rows
};

struct PredictedView {
    std::vector<PredictedSample> samples;
    std::vector<OutlinePoint> outline;
    int cell = 1;  ///< cells of the map between samples, generously
};

/// Every visible one of the points, handed to use(sample).
template <typename Use>
void for_each_visible(const OrientedPoints& points, const SeenFrom& seen, const SceneView& scene,
                      const Eigen::Vector3f& centre, const Pose& T_scene_template, Use use) {
    const Eigen::Matrix3f R = T_scene_template.linear().cast<float>();
    const Eigen::Vector3f t = T_scene_template.translation().cast<float>();
    const Eigen::Vector3f towards =
        (R.transpose() * (scene.map.viewpoint() - R * centre - t)).normalized();
    for (const std::uint32_t i : seen.visible(towards)) {
        PredictedSample s{R * points.points[i] + t, R * points.normals[i], {}};
        s.at = scene.map.place_of(s.point);
        if (s.at.depth_m > 0.0F) use(s);
    }
}

[[nodiscard]] PredictedView predict_view(const TemplateModel& model, const SceneView& scene,
                                         const Pose& T_scene_template);

/// Where the scene's surface ends, seen from an outline point, in cells along its outward
/// direction (negative: before the predicted outline). Nothing where something stands in front or
/// the surface goes on.
[[nodiscard]] std::optional<float> edge_offset(const PredictedView& view, const SceneView& scene,
                                               const OutlinePoint& from, float tolerance_m,
                                               int reach);

}  // namespace gripscan
