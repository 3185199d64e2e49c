#include "ui/render/picking.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscan::ui {
namespace {

struct Candidate {
    std::size_t chunk;
    std::size_t point;
    float depth_m;
    float distance_px;
};

/// Points of a chunk within the radius, in single precision: there may be millions.
void collect(const PointChunk& chunk, std::size_t index, const OrbitCamera& camera,
             const Viewport& viewport, const Eigen::Vector2d& cursor_px,
             const PickSettings& settings, std::vector<Candidate>& found) {
    const Pose T = camera.T_view_world() * chunk.T_world_cloud;
    const Eigen::Matrix3f R = T.linear().cast<float>();
    const Eigen::Vector3f t = T.translation().cast<float>();
    const auto focal =
        static_cast<float>(0.5 * viewport.height_px / std::tan(0.5 * camera.fov_y_rad));
    const Eigen::Vector2f cursor =
        (cursor_px - 0.5 * Eigen::Vector2d(viewport.width_px, viewport.height_px)).cast<float>();
    const auto radius = static_cast<float>(settings.radius_px);
    const auto& points = chunk.cloud->points;
    for (std::size_t i = 0; i < points.size(); i += settings.stride) {
        const Eigen::Vector3f p = R * points[i] + t;
        if (p.z() <= 1e-4F) continue;
        const float inverse = focal / p.z();
        const float dx = p.x() * inverse - cursor.x();
        const float dy = p.y() * inverse - cursor.y();
        const float squared = dx * dx + dy * dy;
        if (squared > radius * radius) continue;
        found.push_back({index, i, p.z(), std::sqrt(squared)});
    }
}

}  // namespace

std::optional<PickedPoint> pick_point(std::span<const PointChunk> chunks, const OrbitCamera& camera,
                                      const Viewport& viewport, const Eigen::Vector2d& cursor_px,
                                      const PickSettings& settings) {
    std::vector<Candidate> found;
    PickSettings checked = settings;
    checked.stride = std::max<std::size_t>(1, settings.stride);
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        if (chunks[i].visible && chunks[i].cloud) {
            collect(chunks[i], i, camera, viewport, cursor_px, checked, found);
        }
    }
    if (found.empty()) return std::nullopt;
    const float front =
        std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
            return a.depth_m < b.depth_m;
        })->depth_m;
    const float behind = front + static_cast<float>(settings.surface_m);
    const Candidate* best = nullptr;
    for (const Candidate& c : found) {
        if (c.depth_m <= behind && (best == nullptr || c.distance_px < best->distance_px)) {
            best = &c;
        }
    }
    const PointChunk& chunk = chunks[best->chunk];
    return PickedPoint{best->chunk, best->point,
                       chunk.T_world_cloud * chunk.cloud->points[best->point].cast<double>(),
                       static_cast<double>(best->distance_px)};
}

}  // namespace gripscan::ui
