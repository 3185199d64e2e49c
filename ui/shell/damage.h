// Where the picture of a frame differs from that of the one before: what Dear ImGui collected is
// compared tile by tile, so that only those tiles are drawn again. A picture that was painted anew
// is drawn again exactly where it is. On a software rasteriser drawing is nearly all that a frame
// costs.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "ui/layout/rect.h"
#include "ui/shell/opaque_picture.h"

namespace gripscan::ui {

class Damage {
  public:
    /// How often the texture of that id has changed.
    using TextureVersion = std::function<std::uint64_t(ImTextureID)>;
    Damage(TextureVersion version, TextureOpaque opaque)
        : version_(std::move(version)), opaque_(std::move(opaque)) {}

    /// Pieces of the picture that hold all that has changed since the last call; few, because each
    /// is drawn by itself. The whole picture in the first call, after forget() and for another
    /// size.
    [[nodiscard]] std::vector<Piece> next(const ImDrawData& frame);
    void forget() { tiles_.clear(); }

  private:
    struct Shown {
        Rect rect;
        ImTextureID texture;
        std::uint64_t version;
    };

    [[nodiscard]] std::uint64_t version_of(ImTextureID id) const;
    [[nodiscard]] std::vector<Piece> painted_anew(const std::vector<OpaquePicture>& pictures);

    TextureVersion version_;
    TextureOpaque opaque_;
    int width_px_ = 0;
    int height_px_ = 0;
    std::vector<std::uint64_t> tiles_;  ///< a sum over what is drawn there, row by row
    std::vector<Shown> pictures_;       ///< the opaque ones
};

/// The same commands with their clip rectangles cut down to one rectangle, those before the first
/// with none, until the end of its life.
class ClippedFrame {
  public:
    ClippedFrame(const ImDrawData& frame, const Rect& rect, std::size_t first_command = 0);
    ~ClippedFrame();
    ClippedFrame(const ClippedFrame&) = delete;
    ClippedFrame& operator=(const ClippedFrame&) = delete;

  private:
    const ImDrawData& frame_;
    std::vector<ImVec4> own_;  ///< clip rectangles of all commands, in order
};

}  // namespace gripscan::ui
