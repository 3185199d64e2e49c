#include "ui/render/cloud_view.h"

#include <optional>

#include "ui/gl/render_target.h"
#include "ui/gl/shader_program.h"
#include "ui/render/line_pass.h"
#include "ui/render/point_pass.h"

namespace gripscan::ui {
namespace {

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
    std::optional<RenderTarget> moving;   ///< colours and depth of a sample, or of all if they fit
    std::optional<RenderTarget> still;    ///< of all points, slice by slice
    std::optional<RenderTarget> picture;  ///< what is shown
    RenderTarget* shown = nullptr;        ///< moving or still
    std::optional<PictureKey> key;
    LevelOfDetail detail;
    Box bounds;

    Status fit(int width_px, int height_px) {
        if (picture && picture->width_px() == width_px && picture->height_px() == height_px) {
            return {};
        }
        key.reset();
        for (auto* target : {&moving, &still, &picture}) {
            const bool flat = target == &picture;
            auto made = RenderTarget::make(width_px, height_px,
                                           flat ? DepthTexture::kNone : DepthTexture::kFloat32);
            if (!made) return forward_error(made.error());
            target->emplace(*std::move(made));
        }
        return {};
    }

    /// The target of a slice; decides which one is shown.
    RenderTarget& target_of(const Slice& slice, bool changed) {
        constexpr double kShowFrom = 0.5;  // of the points: by then denser than the sample
        if (changed) shown = &*moving;
        if (changed || slice.empty()) return *shown;
        if (slice.to >= kShowFrom) shown = &*still;
        return *still;
    }

    void shade_cloud(const Theme& theme, Scale scale, const ClipRange& range, bool eye_dome) {
        picture->bind();
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        shade.use();
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, shown->colour());
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, shown->depth());
        shade.set("cloud_colour", 0);
        shade.set("cloud_depth", 1);
        shade.set("view_top", rgb(theme.view_top));
        shade.set("view_bottom", rgb(theme.view_bottom));
        shade.set("near_m", static_cast<float>(range.near_m));
        shade.set("far_m", static_cast<float>(range.far_m));
        shade.set("strength", eye_dome ? 14.0F : 0.0F);
        shade.set("rings", detail.complete() ? 2 : 1);
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

    parts.target_of(slice, changed).bind();
    parts.points.draw(scene.chunks, scene.camera, viewport, range, scene.settings, theme, scale,
                      slice);
    parts.shade_cloud(theme, scale, range, scene.settings.eye_dome);
    if (scene.lines != nullptr) {
        parts.lines.draw(*scene.lines, scene.camera, viewport, range, scale, parts.shown->depth());
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return {};
}

unsigned int CloudView::texture() const {
    return parts_->picture ? parts_->picture->colour() : 0;
}
bool CloudView::complete() const {
    return parts_->detail.complete();
}
std::vector<std::uint8_t> CloudView::read_rgba() const {
    if (!parts_->picture) return {};
    auto pixels = parts_->picture->read_rgba();
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
