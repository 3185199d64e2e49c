#include "ui/render/cloud_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/gl/render_target.h"
#include "ui/gl/shader_program.h"
#include "ui/gl/texture_version.h"
#include "ui/render/line_pass.h"
#include "ui/render/point_pass.h"

namespace gripscan::ui {
namespace {

/// How much larger the points of a sample are drawn, so that the surface stays closed.
double widening(const Slice& slice) {
    constexpr double kMost = 3.0;  // beyond it edges look like scales
    return slice.coarse ? std::min(kMost, 1.0 / std::sqrt(slice.to - slice.from)) : 1.0;
}

/// Everything a drawn point depends on.
struct PictureKey {
    struct Chunk {
        std::uint64_t id;
        std::uint64_t generation;
        bool visible;
        Colour colour;
        Eigen::Matrix4d T_world_cloud;
        friend bool operator==(const Chunk&, const Chunk&) = default;
    };
    std::vector<Chunk> chunks;
    Eigen::Matrix4d clip_from_world;
    ViewSettings settings;
    std::string theme;
    float scale = 0.0F;
    friend bool operator==(const PictureKey&, const PictureKey&) = default;
};

PictureKey key_of(const Scene& scene, const Eigen::Matrix4d& clip, const Theme& theme,
                  Scale scale) {
    PictureKey key;
    for (const PointChunk& c : scene.chunks) {
        key.chunks.push_back({c.id, c.generation, c.visible, c.colour, c.T_world_cloud.matrix()});
    }
    key.clip_from_world = clip;
    key.settings = scene.settings;
    key.theme = theme.name;
    key.scale = scale.factor();
    return key;
}

Eigen::Vector3f rgb(const Colour& c) {
    return Eigen::Vector3f(c.r, c.g, c.b) / 255.0F;
}

}  // namespace

struct CloudView::Parts {
    Parts(PointPass point_pass, LinePass line_pass, ShaderProgram shade_program)
        : points(std::move(point_pass)),
          lines(std::move(line_pass)),
          shade(std::move(shade_program)) {}

    PointPass points;
    LinePass lines;
    ShaderProgram shade;
    GlVertexArray no_vertices;
    /// Colours and depth of points, and the picture made of them.
    struct Layer {
        std::optional<RenderTarget> points;
        std::optional<RenderTarget> picture;
        double part = 1.0;  ///< of the view's px a side
    };
    Layer sample{{}, {}, 0.5};  ///< some of the points while the view moves: half as fine
    Layer moving;               ///< all of them, where they fit into a frame
    Layer still;                ///< all of them, slice by slice
    Layer* shown = nullptr;
    std::optional<PictureKey> key;
    LineBatch lines_shown;
    LevelOfDetail detail;
    Box bounds;

    Status fit(int width_px, int height_px) {
        const auto& whole = moving.picture;
        if (whole && whole->width_px() == width_px && whole->height_px() == height_px) return {};
        key.reset();
        shown = nullptr;
        for (Layer* layer : {&sample, &moving, &still}) {
            const int width = static_cast<int>(std::ceil(layer->part * width_px));
            const int height = static_cast<int>(std::ceil(layer->part * height_px));
            auto points_made = RenderTarget::make(width, height, DepthTexture::kFloat32);
            if (!points_made) return forward_error(points_made.error());
            layer->points.emplace(*std::move(points_made));
            auto picture_made = RenderTarget::make(width, height, DepthTexture::kNone);
            if (!picture_made) return forward_error(picture_made.error());
            layer->picture.emplace(*std::move(picture_made));
            if (layer->part < 1.0) layer->picture->stretch_smoothly();
        }
        return {};
    }

    /// The layer of a slice; decides which one is shown.
    Layer& layer_of(const Slice& slice, bool changed) {
        constexpr double kShowFrom = 0.5;  // of the points: by then denser than the sample
        if (changed) shown = slice.coarse ? &sample : &moving;
        if (changed || slice.empty()) return *shown;
        if (slice.to >= kShowFrom) shown = &still;
        return still;
    }

    void shade_cloud(const Theme& theme, Scale scale, const ClipRange& range, bool eye_dome) {
        shown->picture->bind();
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        shade.use();
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, shown->points->colour());
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, shown->points->depth());
        shade.set("cloud_colour", 0);
        shade.set("cloud_depth", 1);
        shade.set("view_top", rgb(theme.view_top));
        shade.set("view_bottom", rgb(theme.view_bottom));
        shade.set("near_m", static_cast<float>(range.near_m));
        shade.set("far_m", static_cast<float>(range.far_m));
        shade.set("strength", eye_dome ? 14.0F : 0.0F);
        const bool rests = detail.complete();
        shade.set("rings", rests ? 2 : 1);
        shade.set("neighbours", rests ? 8 : 4);
        shade.set("turn", rests ? Eigen::Vector2f(std::sqrt(0.5F), std::sqrt(0.5F))
                                : Eigen::Vector2f(0.0F, 1.0F));
        shade.set("radius_px", Eigen::Vector2f(1.5F * scale.factor(), 4.0F * scale.factor()));
        glBindVertexArray(no_vertices.name());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glActiveTexture(GL_TEXTURE0);
    }
};

CloudView::CloudView() = default;
CloudView::~CloudView() = default;

Result<std::unique_ptr<CloudView>> CloudView::make() {
    auto points = PointPass::make();
    if (!points) return forward_error(points.error());
    auto lines = LinePass::make();
    if (!lines) return forward_error(lines.error());
    auto shade = ShaderProgram::load("screen.vert", "shade.frag");
    if (!shade) return forward_error(shade.error());
    std::unique_ptr<CloudView> view(new CloudView());
    view->parts_ =
        std::make_unique<Parts>(*std::move(points), *std::move(lines), *std::move(shade));
    return view;
}

Status CloudView::draw(const Scene& scene, int width_px, int height_px, const Theme& theme,
                       Scale scale, double last_frame_ms) {
    Parts& parts = *parts_;
    if (auto fit = parts.fit(width_px, height_px); !fit) return fit;
    const Viewport viewport{static_cast<double>(width_px), static_cast<double>(height_px)};
    parts.points.sync(scene.chunks);
    parts.bounds = parts.points.bounds(scene.chunks);
    const bool something = parts.bounds.valid();
    const Eigen::Vector3d centre =
        something ? Eigen::Vector3d(0.5 * (parts.bounds.min_m + parts.bounds.max_m))
                  : scene.camera.pivot_m;
    const double radius = something ? 0.5 * (parts.bounds.max_m - parts.bounds.min_m).norm() : 1.0;
    const ClipRange range = clip_range(scene.camera, centre, radius);

    PictureKey key = key_of(scene, clip_from_world(scene.camera, viewport, range), theme, scale);
    const bool changed = parts.key != key;
    parts.key = std::move(key);
    if (last_frame_ms > 0.0) parts.detail.measured(last_frame_ms);
    const Slice slice = parts.detail.next(parts.points.total(scene.chunks), changed);

    static const LineBatch kNone;
    const LineBatch& lines = scene.lines != nullptr ? *scene.lines : kNone;
    if (!changed && slice.empty() && lines == parts.lines_shown) return {};  // drawn already
    parts.lines_shown = lines;

    Parts::Layer& layer = parts.layer_of(slice, changed);
    layer.points->bind();
    parts.points.draw(scene.chunks, scene.camera, viewport, range, scene.settings, theme,
                      Scale(scale.factor() * static_cast<float>(layer.part * widening(slice))),
                      slice);
    const double part = parts.shown->part;
    const Scale shown_scale(scale.factor() * static_cast<float>(part));
    parts.shade_cloud(theme, shown_scale, range, scene.settings.eye_dome);
    parts.lines.draw(lines, scene.camera, {part * viewport.width_px, part * viewport.height_px},
                     range, shown_scale, parts.shown->points->depth());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    note_texture_changed(texture(), SeenThrough::kNo);
    return {};
}

unsigned int CloudView::texture() const {
    return parts_->shown != nullptr ? parts_->shown->picture->colour() : 0;
}
bool CloudView::complete() const {
    return parts_->detail.complete();
}
std::vector<std::uint8_t> CloudView::read_rgba() const {
    if (parts_->shown == nullptr) return {};
    auto pixels = parts_->shown->picture->read_rgba();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return pixels;
}
Box CloudView::bounds() const {
    return parts_->bounds;
}
const LevelOfDetail& CloudView::level_of_detail() const {
    return parts_->detail;
}

}  // namespace gripscan::ui
