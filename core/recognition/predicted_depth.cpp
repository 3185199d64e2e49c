#include "core/recognition/predicted_depth.h"

#include <algorithm>
#include <cmath>

namespace gripscan {
namespace {

/// Surfaces seen flatter than this (cosine) are measured by no camera.
constexpr float kFlattest = 0.1F;
/// Radius of a point's disc in spacings: the smallest that leaves no holes between the points.
constexpr float kRadius = 0.9F;
/// A disc counts as deeper by this times the distance from its middle: of overlapping discs of one
/// surface the one in whose middle the cell lies wins.
constexpr float kSlope = 2.0F;

}  // namespace

PredictedDepth::PredictedDepth(const TemplateModel& model, const SceneView& scene,
                               const Pose& T_scene_template) {
    const Eigen::Matrix3f R = T_scene_template.linear().cast<float>();
    const Eigen::Vector3f t = T_scene_template.translation().cast<float>();
    const Eigen::Vector3f eye = R.transpose() * (scene.map.viewpoint() - t);
    std::vector<ViewMap::Place> places;
    float nearest_m = 1e9F;
    for (std::size_t i = 0; i < model.dense.size(); ++i) {
        const Eigen::Vector3f& p = model.dense.points[i];
        const Eigen::Vector3f& n = model.dense.normals[i];
        const Eigen::Vector3f towards = eye - p;
        if (n.dot(towards) < kFlattest * towards.norm()) continue;
        const Eigen::Vector3f p_scene = R * p + t;
        const ViewMap::Place place = scene.map.place_of(p_scene);
        if (place.depth_m <= 0.0F) continue;
        surface_.add(p_scene, R * n);
        depth_m_.push_back(place.depth_m);
        border_.push_back(model.dense_border[i]);
        places.push_back(place);
        nearest_m = std::min(nearest_m, place.depth_m);
    }
    if (places.empty()) return;
    const float radius_m = kRadius * static_cast<float>(model.dense_m);
    const float cells_per_unit = scene.map.cells_per_unit();
    frame(places, scene, static_cast<int>(radius_m * cells_per_unit / nearest_m) + 1);
    std::vector<float> cost(index_.size(), 1e9F);
    for (std::size_t i = 0; i < places.size(); ++i) {
        draw(places[i], static_cast<std::int32_t>(i), radius_m, places[i].depth_m / cells_per_unit,
             cost);
    }
}

void PredictedDepth::frame(const std::vector<ViewMap::Place>& places, const SceneView& scene,
                           int margin) {
    int low_c = places.front().column;
    int high_c = low_c;
    int low_r = places.front().row;
    int high_r = low_r;
    for (const ViewMap::Place& p : places) {
        low_c = std::min(low_c, p.column);
        high_c = std::max(high_c, p.column);
        low_r = std::min(low_r, p.row);
        high_r = std::max(high_r, p.row);
    }
    // Only what the map holds: a part at the camera's very front would fill millions of cells.
    first_column_ = std::max(0, low_c - margin);
    first_row_ = std::max(0, low_r - margin);
    width_ = std::max(0, std::min(scene.map.width() - 1, high_c + margin) - first_column_ + 1);
    height_ = std::max(0, std::min(scene.map.height() - 1, high_r + margin) - first_row_ + 1);
    index_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), -1);
}

void PredictedDepth::draw(const ViewMap::Place& place, std::int32_t i, float radius_m, float cell_m,
                          std::vector<float>& cost) {
    const float radius = radius_m / cell_m;
    const int reach = static_cast<int>(radius);
    for (int dr = -reach; dr <= reach; ++dr) {
        const int r = place.row + dr - first_row_;
        if (r < 0 || r >= height_) continue;
        for (int dc = -reach; dc <= reach; ++dc) {
            const int c = place.column + dc - first_column_;
            if (c < 0 || c >= width_) continue;
            const auto away = std::sqrt(static_cast<float>(dc * dc + dr * dr));
            if (away > radius) continue;
            const std::size_t k = static_cast<std::size_t>(r) * static_cast<std::size_t>(width_) +
                                  static_cast<std::size_t>(c);
            const float here = place.depth_m + kSlope * away * cell_m;
            if (here >= cost[k]) continue;
            cost[k] = here;
            index_[k] = i;
        }
    }
}

}  // namespace gripscan
