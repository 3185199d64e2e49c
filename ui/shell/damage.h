// Where the picture of a frame differs from that of the one before: what Dear ImGui collected is
// compared tile by tile, so that only those tiles are drawn again. On a software rasteriser drawing
// is nearly all that a frame costs.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "ui/layout/rect.h"

namespace gripscan::ui {

class Damage {
  public:
    /// How often the texture of that id has changed.
    using TextureVersion = std::function<std::uint64_t(ImTextureID)>;
    explicit Damage(TextureVersion version) : version_(std::move(version)) {}

    /// Rectangles in px, none overlapping another, that hold all that has changed since the last
    /// call; few, because each is drawn by itself. The whole picture in the first call, after
    /// forget() and for another size.
    [[nodiscard]] std::vector<Rect> next(const ImDrawData& frame);
    void forget() { tiles_.clear(); }

  private:
    TextureVersion version_;
    int width_px_ = 0;
    int height_px_ = 0;
    std::vector<std::uint64_t> tiles_;  ///< a sum over what is drawn there, row by row
};

/// The same commands with their clip rectangles cut down to one rectangle, until the end of its
/// life.
class ClippedFrame {
  public:
    ClippedFrame(const ImDrawData& frame, const Rect& rect);
    ~ClippedFrame();
    ClippedFrame(const ClippedFrame&) = delete;
    ClippedFrame& operator=(const ClippedFrame&) = delete;

  private:
    const ImDrawData& frame_;
    std::vector<ImVec4> own_;  ///< clip rectangles of all commands, in order
};

}  // namespace gripscan::ui
