// A picture to draw into: colour and, where wanted, depth as a texture that shaders can read.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "ui/gl/gl_object.h"

namespace gripscan::ui {

enum class DepthTexture { kNone, kFloat32 };

class RenderTarget {
  public:
    /// Sizes in px, 1 … 16384. Fails where the driver refuses.
    [[nodiscard]] static Result<RenderTarget> make(int width_px, int height_px, DepthTexture depth);

    /// Draws go here until the next bind; the viewport is the whole target.
    void bind() const;
    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return height_px_; }
    [[nodiscard]] GLuint colour() const { return colour_.name(); }
    /// 0 without a depth texture.
    [[nodiscard]] GLuint depth() const { return depth_ ? depth_->name() : 0; }

    /// Shown larger it is smoothed.
    void stretch_smoothly() const;
    /// Its colours into the window's framebuffer, which is as large and is bound after it.
    void copy_to_window() const;

    /// RGBA rows from top to bottom.
    [[nodiscard]] std::vector<std::uint8_t> read_rgba() const;
    /// Depths (0 near … 1 far) of a window with its lower left corner at (x, y), rows upwards.
    [[nodiscard]] std::vector<float> read_depth(int x, int y, int width, int height) const;

  private:
    RenderTarget(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}
    int width_px_;
    int height_px_;
    GlFramebuffer framebuffer_;
    GlTexture colour_;
    std::optional<GlTexture> depth_;
};

/// The bound framebuffer as RGBA rows from top to bottom: how a window is photographed.
[[nodiscard]] std::vector<std::uint8_t> read_framebuffer_rgba(int width_px, int height_px);

}  // namespace gripscan::ui
