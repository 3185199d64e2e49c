#include "ui/shell/opaque_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gripscan::ui {
namespace {

/// Smaller ones save less than a piece of its own costs.
constexpr long kWorth_px = 200L * 200L;

/// The rectangle of two triangles that fill one, in whole pixels of the display; nothing for other
/// shapes and where a corner shows through.
std::optional<Rect> filled_by(const ImDrawList& list, const ImDrawCmd& command,
                              const ImVec2& origin) {
    if (command.UserCallback != nullptr || command.ElemCount != 6) return std::nullopt;
    const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
    ImVec2 least = vertices[index[0]].pos;
    ImVec2 most = least;
    float twice_area = 0.0F;
    for (unsigned i = 0; i < 6; i += 3) {
        const ImVec2 a = vertices[index[i]].pos;
        const ImVec2 b = vertices[index[i + 1]].pos;
        const ImVec2 c = vertices[index[i + 2]].pos;
        twice_area += std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
    }
    for (unsigned i = 0; i < 6; ++i) {
        const ImDrawVert& v = vertices[index[i]];
        if (v.col >> IM_COL32_A_SHIFT != 0xFF) return std::nullopt;
        least = {std::min(least.x, v.pos.x), std::min(least.y, v.pos.y)};
        most = {std::max(most.x, v.pos.x), std::max(most.y, v.pos.y)};
    }
    // Every corner stands at one of the box, and the triangles fill it.
    for (unsigned i = 0; i < 6; ++i) {
        const ImVec2 p = vertices[index[i]].pos;
        if ((p.x != least.x && p.x != most.x) || (p.y != least.y && p.y != most.y)) {
            return std::nullopt;
        }
    }
    if (twice_area < 2.0F * (most.x - least.x) * (most.y - least.y) - 0.5F) return std::nullopt;
    const float sides[] = {
        std::max(least.x, command.ClipRect.x) - origin.x,
        std::max(least.y, command.ClipRect.y) - origin.y,
        std::min(most.x, command.ClipRect.z) - origin.x,
        std::min(most.y, command.ClipRect.w) - origin.y,
    };
    // Where a side runs through pixels, they show what lies under them, or do not.
    if (std::ranges::any_of(sides, [](float side) { return side != std::floor(side); })) {
        return std::nullopt;
    }
    const auto left = static_cast<int>(sides[0]);
    const auto top = static_cast<int>(sides[1]);
    const Rect rect{left, top, static_cast<int>(sides[2]) - left, static_cast<int>(sides[3]) - top};
    return rect.empty() ? std::nullopt : std::optional(rect);
}

Rect common(const Rect& a, const Rect& b) {
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::min(a.right(), b.right()) - x, std::min(a.bottom(), b.bottom()) - y};
}

long area(const Rect& rect) {
    return rect.empty() ? 0 : static_cast<long>(rect.width) * rect.height;
}

}  // namespace

std::vector<OpaquePicture> opaque_pictures(const ImDrawData& frame, const TextureOpaque& opaque) {
    if (!opaque) return {};
    std::vector<OpaquePicture> pictures;
    std::size_t number = 0;
    for (int n = 0; n < frame.CmdListsCount; ++n) {
        const ImDrawList& list = *frame.CmdLists[n];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const std::size_t own = number++;
            if (!opaque(command.GetTexID())) continue;
            const auto rect = filled_by(list, command, frame.DisplayPos);
            if (rect && area(*rect) >= kWorth_px)
                pictures.push_back({*rect, own, command.GetTexID()});
        }
    }
    return pictures;
}

std::vector<Piece> pieces_of(const Rect& rect, std::span<const OpaquePicture> pictures) {
    if (rect.empty()) return {};
    const OpaquePicture* best = nullptr;
    long most = kWorth_px - 1;
    for (const OpaquePicture& picture : pictures) {
        const long covered = area(common(rect, picture.rect));
        if (covered <= most) continue;
        most = covered;
        best = &picture;
    }
    if (best == nullptr) return {{rect, 0}};
    const Rect in = common(rect, best->rect);
    std::vector<Piece> pieces{{in, best->command}};
    const Rect around[] = {
        {rect.x, rect.y, rect.width, in.y - rect.y},
        {rect.x, in.bottom(), rect.width, rect.bottom() - in.bottom()},
        {rect.x, in.y, in.x - rect.x, in.height},
        {in.right(), in.y, rect.right() - in.right(), in.height},
    };
    for (const Rect& strip : around)
        std::ranges::copy(pieces_of(strip, pictures), std::back_inserter(pieces));
    return pieces;
}

}  // namespace gripscan::ui
