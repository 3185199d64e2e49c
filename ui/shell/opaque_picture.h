// What lies under an opaque picture need not be drawn. On a software rasteriser the surfaces below
// a large one cost as much as the picture itself.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "ui/layout/rect.h"

namespace gripscan::ui {

/// A picture without transparency that fills a rectangle.
struct OpaquePicture {
    Rect rect;            ///< px that it fills wholly
    std::size_t command;  ///< the one that draws it, counted over all lists of the frame
    ImTextureID texture;
};

/// Whether no pixel of that texture shows through.
using TextureOpaque = std::function<bool(ImTextureID)>;

/// Those worth to be known, in the order in which they are drawn.
[[nodiscard]] std::vector<OpaquePicture> opaque_pictures(const ImDrawData& frame,
                                                         const TextureOpaque& opaque);

/// A part of the frame, and the first command that can be seen in it.
struct Piece {
    Rect rect;
    std::size_t first_command = 0;
    friend bool operator==(const Piece&, const Piece&) = default;
};

/// Disjoint pieces that are `rect` together; few, because each is drawn by itself.
[[nodiscard]] std::vector<Piece> pieces_of(const Rect& rect,
                                           std::span<const OpaquePicture> pictures);

}  // namespace gripscan::ui
