#include "ui/panels/view3d_scene.h"

#include <algorithm>

namespace gripscan::ui {
namespace {

/// The last visible one in the order of the turn.
const SceneCloud* last_visible(const SceneParts& parts) {
    const auto found = std::find_if(parts.clouds.rbegin(), parts.clouds.rend(),
                                    [](const SceneCloud& cloud) { return cloud.visible; });
    return found == parts.clouds.rend() ? nullptr : &*found;
}

bool belongs(const SceneCloud& cloud, PaneContent content, const SceneCloud* last, bool of_object) {
    if (content == PaneContent::kAll) return true;
    // Gripper and object side by side.
    if (of_object) return (cloud.role == CloudRole::kHolder) == (content == PaneContent::kFirst);
    const bool second =
        cloud.role == CloudRole::kSource || (cloud.role == CloudRole::kView && &cloud == last);
    return second == (content == PaneContent::kSecond);
}

}  // namespace

namespace {

/// Where each cloud has one colour.
Colour colour_of(const SceneCloud& cloud, const Theme& theme) {
    if (cloud.colour != nullptr) return theme.*cloud.colour;
    if (cloud.role == CloudRole::kScene) return theme.text_third;
    return cloud.role == CloudRole::kSource ? theme.source : theme.target;
}

}  // namespace

std::vector<PointChunk> chunks_of(const SceneParts& parts, PaneContent content,
                                  const Theme& theme) {
    const SceneCloud* last = last_visible(parts);
    std::vector<PointChunk> chunks;
    for (const SceneCloud& cloud : parts.clouds) {
        PointChunk chunk;
        chunk.id = cloud.id;
        chunk.generation = cloud.generation;
        chunk.cloud = cloud.cloud;
        chunk.residual_m = cloud.residual_m;
        chunk.T_world_cloud = cloud.T_first_cloud;
        // The first view stands at the beginning of step 1 and has its colour.
        chunk.step = static_cast<std::uint16_t>(std::max(1, cloud.step));
        chunk.colour = colour_of(cloud, theme);
        chunk.visible = cloud.visible && belongs(cloud, content, last, parts.split != nullptr);
        chunks.push_back(std::move(chunk));
    }
    return chunks;
}

Box bounds_of_scene(const SceneParts& parts) {
    constexpr std::size_t kInAll = 40000;
    const std::size_t stride = 1 + visible_points(parts) / kInAll;
    Box box{Eigen::Vector3d::Constant(1e300), Eigen::Vector3d::Constant(-1e300)};
    for (const SceneCloud& cloud : parts.clouds) {
        if (!cloud.visible) continue;
        for (std::size_t i = 0; i < cloud.cloud->size(); i += stride) {
            const Eigen::Vector3d p = cloud.T_first_cloud * cloud.cloud->points[i].cast<double>();
            box.min_m = box.min_m.cwiseMin(p);
            box.max_m = box.max_m.cwiseMax(p);
        }
    }
    return box;
}

Box whole_scene(const Snapshot& snapshot, const Box& bounds) {
    if (!snapshot.cell.region) return bounds;
    Box box = *snapshot.cell.region;
    if (bounds.valid()) {
        box.min_m = box.min_m.cwiseMin(bounds.min_m);
        box.max_m = box.max_m.cwiseMax(bounds.max_m);
    }
    return box;
}

OrbitCamera first_look(const Box& around, const Viewport& viewport) {
    OrbitCamera camera;
    camera.yaw_rad = 0.45;
    camera.pitch_rad = 0.30;
    return fitted(camera, around, viewport);
}

OrbitCamera commanded(const OrbitCamera& camera, ViewCommand command, const Snapshot& snapshot,
                      const Box& bounds, const Viewport& viewport) {
    switch (command) {
        case ViewCommand::kFitSelection:
            return bounds.valid() ? fitted(camera, bounds, viewport) : camera;
        case ViewCommand::kFitAll: {
            const Box all = whole_scene(snapshot, bounds);
            return all.valid() ? fitted(camera, all, viewport) : camera;
        }
        case ViewCommand::kFront:
            return axis_view(camera, AxisView::kFront);
        case ViewCommand::kSide:
            return axis_view(camera, AxisView::kSide);
        case ViewCommand::kTop:
            return axis_view(camera, AxisView::kTop);
        case ViewCommand::kAlongAxis:
            return snapshot.cell.axis ? looking_along(camera, *snapshot.cell.axis) : camera;
        case ViewCommand::kStereoCamera: {
            const Box all = whole_scene(snapshot, bounds);
            return all.valid() ? from_stereo_camera(camera, 0.5 * (all.min_m.z() + all.max_m.z()))
                               : camera;
        }
        case ViewCommand::kMeasure:
        case ViewCommand::kSideBySide:
        case ViewCommand::kEyeDome:
        case ViewCommand::kLarger:
        case ViewCommand::kSmaller:
            break;
    }
    return camera;
}

ViewSettings view_settings(ColourBy by, const LegendRange& range, const Snapshot& snapshot,
                           const SceneParts& parts, const View3dState& state) {
    ViewSettings settings;
    settings.colour_by = by;
    const double per_unit = by == ColourBy::kChunk ? 1.0 : colouring(by).per_unit;
    settings.range_from = per_unit * range.from;
    settings.range_to = per_unit * range.to;
    settings.point_size_px = state.point_size_px;
    settings.eye_dome = state.eye_dome;
    if (parts.kind == SceneKind::kTemplate) {
        settings.keep = snapshot.filter.crop;
        settings.keep_outside = snapshot.filter.invert_crop;
    }
    return settings;
}

std::optional<PickedPoint> pick_in(std::span<const PointChunk> chunks, const OrbitCamera& camera,
                                   const Viewport& viewport, const Eigen::Vector2d& px,
                                   Scale scale) {
    constexpr std::size_t kAtOnce = 600000;
    std::size_t total = 0;
    for (const PointChunk& chunk : chunks) total += chunk.visible ? chunk.cloud->size() : 0;
    PickSettings settings;
    settings.radius_px = static_cast<double>(scale.px(8.0F));
    settings.stride = 1 + total / kAtOnce;
    return pick_point(chunks, camera, viewport, px, settings);
}

CursorReading reading_of(const PickedPoint& point, std::span<const PointChunk> chunks) {
    const PointChunk& chunk = chunks[point.chunk];
    CursorReading reading;
    reading.point_m = point.position_m;
    reading.step = chunk.step;
    if (chunk.residual_m && point.point < chunk.residual_m->size() &&
        (*chunk.residual_m)[point.point] >= 0.0F) {
        reading.residual_m = (*chunk.residual_m)[point.point];
    }
    return reading;
}

LegendRange RangeCache::range(ColourBy by, const SceneParts& parts, int min_seen,
                              const View3dState& state) {
    if (const auto& typed = state.typed_ranges[static_cast<std::size_t>(by)]) return *typed;
    Key key{by, min_seen, parts.steps_total, {}};
    for (const SceneCloud& cloud : parts.clouds) {
        if (cloud.visible) key.clouds.emplace_back(cloud.id, cloud.generation);
    }
    if (key != key_) {
        range_ = usual_range(by, parts, min_seen);
        key_ = std::move(key);
    }
    return range_;
}

}  // namespace gripscan::ui
