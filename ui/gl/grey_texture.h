// A grey picture on the graphics card.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ui/gl/gl_object.h"

namespace gripscan::ui {

/// Needs a current context from its making to its end.
class GreyTexture {
  public:
    /// Rows from top to bottom, `stride` bytes apart. Sampled as r = g = b = grey, opaque.
    GreyTexture(const std::uint8_t* grey, int width_px, int height_px, std::size_t stride);

    [[nodiscard]] GLuint name() const { return texture_.name(); }

  private:
    GlTexture texture_;
};

}  // namespace gripscan::ui
