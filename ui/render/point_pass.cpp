#include "ui/render/point_pass.h"

#include <algorithm>
#include <limits>

namespace gripscan::ui {
namespace {

/// Numbers of points.vert.
enum class ShaderColour { kMap = 0, kBrightness = 1, kNormal = 2, kOne = 3, kDepth = 4 };

struct Recipe {
    ShaderColour colour;
    PointValue value;
    ColourMap map;
};

Recipe recipe_of(ColourBy by) {
    switch (by) {
        case ColourBy::kImage:
            return {ShaderColour::kBrightness, PointValue::kNone, ColourMap::kStep};
        case ColourBy::kStep:
            return {ShaderColour::kMap, PointValue::kStep, ColourMap::kStep};
        case ColourBy::kResidual:
            return {ShaderColour::kMap, PointValue::kResidual, ColourMap::kResidual};
        case ColourBy::kSeen:
            return {ShaderColour::kMap, PointValue::kSeen, ColourMap::kSeen};
        case ColourBy::kDepth:
            return {ShaderColour::kDepth, PointValue::kNone, ColourMap::kDepth};
        case ColourBy::kNormal:
            return {ShaderColour::kNormal, PointValue::kNone, ColourMap::kStep};
        case ColourBy::kSigma:
            return {ShaderColour::kMap, PointValue::kSigma, ColourMap::kResidual};
        case ColourBy::kChunk:
            break;
    }
    return {ShaderColour::kOne, PointValue::kNone, ColourMap::kStep};
}

Eigen::Vector3f rgb(const Colour& c) {
    return Eigen::Vector3f(c.r, c.g, c.b) / 255.0F;
}

void upload_map(const GlTexture& texture, ColourMap map) {
    const auto bytes = map_bytes(map);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 256, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

PointPass::PointPass(ShaderProgram program) : program_(std::move(program)) {
    for (std::size_t i = 0; i < maps_.size(); ++i) {
        upload_map(maps_[i], static_cast<ColourMap>(i));
    }
}

Result<PointPass> PointPass::make() {
    auto program = ShaderProgram::load("points.vert", "points.frag");
    if (!program) return forward_error(program.error());
    return PointPass(*std::move(program));
}

std::size_t PointPass::total(std::span<const PointChunk> chunks) const {
    std::size_t sum = 0;
    for (const PointChunk& chunk : chunks) sum += chunk.visible ? store_.size(chunk.id) : 0;
    return sum;
}

Box PointPass::bounds(std::span<const PointChunk> chunks) const {
    constexpr double kFar = std::numeric_limits<double>::max();
    Box all{Eigen::Vector3d::Constant(kFar), Eigen::Vector3d::Constant(-kFar)};
    for (const PointChunk& chunk : chunks) {
        const Box box = store_.bounds(chunk.id);
        if (!chunk.visible || (box.min_m.array() > box.max_m.array()).any()) continue;
        for (const Eigen::Vector3d& corner : box.corners()) {
            const Eigen::Vector3d world = chunk.T_world_cloud * corner;
            all.min_m = all.min_m.cwiseMin(world);
            all.max_m = all.max_m.cwiseMax(world);
        }
    }
    return all;
}

void PointPass::set_colours(const ViewSettings& settings, const Theme& theme) const {
    const Recipe recipe = recipe_of(settings.colour_by);
    const double span = settings.range_to - settings.range_from;
    program_.set("colour_by", static_cast<int>(recipe.colour));
    program_.set("map_from", static_cast<float>(settings.range_from));
    program_.set("map_per_value", span != 0.0 ? static_cast<float>(1.0 / span) : 0.0F);
    program_.set("under_is_grey", settings.colour_by == ColourBy::kSeen ? 1.0F : 0.0F);
    program_.set("grey", rgb(theme.too_few));
    program_.set("keep", settings.keep ? (settings.keep_outside ? 2 : 1) : 0);
    const Box keep = settings.keep.value_or(Box{});
    program_.set("keep_min", Eigen::Vector3f(keep.min_m.cast<float>()));
    program_.set("keep_max", Eigen::Vector3f(keep.max_m.cast<float>()));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, maps_[static_cast<std::size_t>(recipe.map)].name());
    program_.set("map", 0);
}

void PointPass::draw(std::span<const PointChunk> chunks, const OrbitCamera& camera,
                     const Viewport& viewport, const ClipRange& range, const ViewSettings& settings,
                     const Theme& theme, Scale scale, const Slice& slice) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_PROGRAM_POINT_SIZE);
    if (slice.clear) {
        glClearColor(0, 0, 0, 0);
        glClearDepth(1.0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    if (slice.empty()) return;
    program_.use();
    set_colours(settings, theme);
    constexpr float kCoarser = 1.75F;  // a sample leaves gaps
    const float size = std::clamp(settings.point_size_px, 1.0F, 10.0F) * scale.factor() *
                       (slice.coarse ? kCoarser : 1.0F);
    program_.set("size_px", size);
    const Eigen::Matrix4d clip = clip_from_world(camera, viewport, range);
    const Eigen::Matrix4d view = camera.T_view_world().matrix();
    const PointValue value = recipe_of(settings.colour_by).value;
    for (const PointChunk& chunk : chunks) {
        if (!chunk.visible) continue;
        const Eigen::Matrix4d pose = chunk.T_world_cloud.matrix();
        program_.set("clip_from_cloud", Eigen::Matrix4f((clip * pose).cast<float>()));
        program_.set("view_from_cloud", Eigen::Matrix4f((view * pose).cast<float>()));
        program_.set("world_from_cloud", Eigen::Matrix4f(pose.cast<float>()));
        program_.set("depth_from_cloud", Eigen::Vector4f(pose.row(2).transpose().cast<float>()));
        program_.set("one_colour", rgb(chunk.colour));
        const std::size_t size_of_chunk = store_.size(chunk.id);
        store_.draw(chunk.id, value, slice.first(size_of_chunk), slice.end(size_of_chunk));
    }
    glBindVertexArray(0);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace gripscan::ui
