// The 3D view as a picture: clouds with eye-dome lighting, lines over them. Drawn into a texture
// that a panel shows like any other image.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/base/result.h"
#include "ui/layout/scale.h"
#include "ui/render/level_of_detail.h"
#include "ui/render/line_batch.h"
#include "ui/render/orbit_camera.h"
#include "ui/render/point_chunk.h"
#include "ui/theme/colour_by.h"
#include "ui/theme/theme.h"

namespace gripscan::ui {

struct ViewSettings {
    ColourBy colour_by = ColourBy::kImage;
    double range_from = 0.0;     ///< value at the low end of the legend: m, or a count
    double range_to = 1.0;       ///< at its high end; of kDepth this is the near end
    float point_size_px = 2.0F;  ///< at 100 %, 1 … 10
    bool eye_dome = true;
    std::optional<Box> keep = std::nullopt;  ///< in the world; points outside it are grey
    bool keep_outside = false;               ///< keep what lies outside it instead
    friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

struct Scene {
    std::span<const PointChunk> chunks;
    const LineBatch* lines = nullptr;  ///< may change in every frame at no cost for the points
    OrbitCamera camera;
    ViewSettings settings;
};

class CloudView {
  public:
    /// Needs a current OpenGL context, here and until its end.
    [[nodiscard]] static Result<std::unique_ptr<CloudView>> make();
    ~CloudView();
    CloudView(const CloudView&) = delete;
    CloudView& operator=(const CloudView&) = delete;

    /// Draws one frame. `last_frame_ms` is the time of the whole frame before (0: unknown); from it
    /// follows how many points this one may draw.
    [[nodiscard]] Status draw(const Scene& scene, int width_px, int height_px, const Theme& theme,
                              Scale scale, double last_frame_ms);

    /// Name of the texture with the picture, first row at the bottom; 0 before the first frame.
    [[nodiscard]] unsigned int texture() const;
    /// Every point is in the picture: no further frame is needed until something changes.
    [[nodiscard]] bool complete() const;
    /// RGBA rows from top to bottom; half as wide and high while only a sample is shown.
    [[nodiscard]] std::vector<std::uint8_t> read_rgba() const;
    /// Around all that is visible, in the world; not valid where there is nothing.
    [[nodiscard]] Box bounds() const;
    [[nodiscard]] const LevelOfDetail& level_of_detail() const;

  private:
    CloudView();
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace gripscan::ui
