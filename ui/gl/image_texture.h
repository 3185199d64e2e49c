// A picture in the memory of the graphics card, for Dear ImGui to draw.
#pragma once

#include <cstdint>

#include "ui/gl/gl_object.h"

namespace gripscan::ui {

/// How a small picture is shown large; large ones shown small are averaged.
enum class Magnified { kPixels, kSmooth };

class ImageTexture {
  public:
    explicit ImageTexture(Magnified magnified = Magnified::kPixels) : magnified_(magnified) {}

    /// Replaces what is there. `row_bytes`: from one row to the next.
    void upload_grey(int width_px, int height_px, const std::uint8_t* pixels,
                     std::size_t row_bytes);
    void upload_rgba(int width_px, int height_px, const std::uint8_t* pixels,
                     std::size_t row_bytes);

    /// 0 before the first upload.
    [[nodiscard]] GLuint name() const { return width_px_ > 0 ? texture_.name() : 0; }
    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return height_px_; }

  private:
    void upload(int width_px, int height_px, const void* pixels, std::size_t row_bytes,
                int channels);
    Magnified magnified_;
    GlTexture texture_;
    int width_px_ = 0;
    int height_px_ = 0;
};

}  // namespace gripscan::ui
