// Draws slices of the clouds into the bound target.
#pragma once

#include <array>

#include "ui/gl/shader_program.h"
#include "ui/render/cloud_view.h"
#include "ui/render/point_store.h"
#include "ui/theme/colour_map.h"

namespace gripscan::ui {

class PointPass {
  public:
    [[nodiscard]] static Result<PointPass> make();

    void sync(std::span<const PointChunk> chunks) { store_.sync(chunks); }
    /// Points of the visible chunks.
    [[nodiscard]] std::size_t total(std::span<const PointChunk> chunks) const;
    /// Around the visible chunks, in the world.
    [[nodiscard]] Box bounds(std::span<const PointChunk> chunks) const;

    void draw(std::span<const PointChunk> chunks, const OrbitCamera& camera,
              const Viewport& viewport, const ClipRange& range, const ViewSettings& settings,
              const Theme& theme, Scale scale, const Slice& slice);

  private:
    explicit PointPass(ShaderProgram program);
    void set_colours(const ViewSettings& settings, const Theme& theme) const;

    ShaderProgram program_;
    PointStore store_;
    std::array<GlTexture, 4> maps_;  ///< by ColourMap
};

}  // namespace gripscan::ui
