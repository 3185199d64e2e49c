#include "ui/shell/damage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace gripscan::ui {
namespace {

constexpr int kTile_px = 32;
/// Every rectangle hands all vertices over again.
constexpr std::size_t kMostRects = 3;

std::uint64_t mixed(std::uint64_t sum, std::uint64_t value) {
    sum ^= value;
    sum *= 0x9E3779B97F4A7C15ULL;  // 2^64 over the golden ratio: spreads every bit upwards
    return sum ^ (sum >> 29U);
}

std::uint64_t bits_of(float a, float b) {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::memcpy(&low, &a, sizeof low);
    std::memcpy(&high, &b, sizeof high);
    return static_cast<std::uint64_t>(high) << 32U | low;
}

/// The tiles of a picture, and what is added to them.
struct Tiles {
    int columns;
    int rows;
    std::vector<std::uint64_t> sums;

    Tiles(int width_px, int height_px)
        : columns((width_px + kTile_px - 1) / kTile_px),
          rows((height_px + kTile_px - 1) / kTile_px),
          sums(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 1) {}

    [[nodiscard]] Rect rect(std::size_t tile) const {
        const int x = static_cast<int>(tile) % columns;
        const int y = static_cast<int>(tile) / columns;
        return {x * kTile_px, y * kTile_px, kTile_px, kTile_px};
    }

    void add(const ImVec4& bounds, std::uint64_t value) {
        const int left = std::max(0, static_cast<int>(std::floor(bounds.x)) / kTile_px);
        const int top = std::max(0, static_cast<int>(std::floor(bounds.y)) / kTile_px);
        const int right = std::min(columns - 1, static_cast<int>(std::ceil(bounds.z)) / kTile_px);
        const int bottom = std::min(rows - 1, static_cast<int>(std::ceil(bounds.w)) / kTile_px);
        for (int y = top; y <= bottom; ++y) {
            for (int x = left; x <= right; ++x) {
                std::uint64_t& sum = sums[static_cast<std::size_t>(y * columns + x)];
                sum = mixed(sum, value);
            }
        }
    }
};

void add_command(const ImDrawList& list, const ImDrawCmd& command, const ImVec2& origin,
                 std::uint64_t texture, Tiles& tiles) {
    const ImVec4 clip{command.ClipRect.x - origin.x, command.ClipRect.y - origin.y,
                      command.ClipRect.z - origin.x, command.ClipRect.w - origin.y};
    const std::uint64_t common =
        mixed(mixed(texture, bits_of(clip.x, clip.y)), bits_of(clip.z, clip.w));
    const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
    for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
        std::uint64_t sum = common;
        constexpr float kFar = std::numeric_limits<float>::max();
        ImVec4 bounds{kFar, kFar, -kFar, -kFar};
        for (unsigned corner = 0; corner < 3; ++corner) {
            const ImDrawVert& v = vertices[index[i + corner]];
            sum = mixed(sum, bits_of(v.pos.x, v.pos.y));
            sum = mixed(sum, bits_of(v.uv.x, v.uv.y));
            sum = mixed(sum, v.col);
            bounds = {
                std::min(bounds.x, v.pos.x - origin.x), std::min(bounds.y, v.pos.y - origin.y),
                std::max(bounds.z, v.pos.x - origin.x), std::max(bounds.w, v.pos.y - origin.y)};
        }
        bounds = {std::max(bounds.x, clip.x), std::max(bounds.y, clip.y),
                  std::min(bounds.z, clip.z), std::min(bounds.w, clip.w)};
        if (bounds.x < bounds.z && bounds.y < bounds.w) tiles.add(bounds, sum);
    }
}

Rect around(const Rect& a, const Rect& b) {
    const int x = std::min(a.x, b.x);
    const int y = std::min(a.y, b.y);
    return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

long area(const Rect& rect) {
    return static_cast<long>(rect.width) * rect.height;
}

/// Joins the two that waste least, until there are few and none overlaps another.
void join(std::vector<Rect>& rects) {
    const auto overlap = [&] {
        for (std::size_t i = 0; i < rects.size(); ++i) {
            for (std::size_t j = i + 1; j < rects.size(); ++j) {
                if (rects[i].overlaps(rects[j])) return true;
            }
        }
        return false;
    };
    while (rects.size() > kMostRects || overlap()) {
        long least = std::numeric_limits<long>::max();
        std::size_t first = 0;
        std::size_t second = 1;
        for (std::size_t i = 0; i < rects.size(); ++i) {
            for (std::size_t j = i + 1; j < rects.size(); ++j) {
                const long waste =
                    rects[i].overlaps(rects[j])
                        ? -1
                        : area(around(rects[i], rects[j])) - area(rects[i]) - area(rects[j]);
                if (waste >= least) continue;
                least = waste;
                first = i;
                second = j;
            }
        }
        rects[first] = around(rects[first], rects[second]);
        rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(second));
    }
}

/// One rectangle for every run of changed tiles; runs of the same columns in rows below each other
/// are one.
std::vector<Rect> runs_of(const std::vector<bool>& changed, int columns, int rows) {
    std::vector<Rect> runs;  // in tiles
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            if (!changed[static_cast<std::size_t>(y * columns + x)]) continue;
            const int from = x;
            while (x < columns && changed[static_cast<std::size_t>(y * columns + x)]) ++x;
            const auto above = std::ranges::find_if(runs, [&](const Rect& r) {
                return r.x == from && r.width == x - from && r.bottom() == y;
            });
            if (above != runs.end()) {
                ++above->height;
            } else {
                runs.push_back({from, y, x - from, 1});
            }
        }
    }
    return runs;
}

}  // namespace

std::uint64_t Damage::version_of(ImTextureID id) const {
    return version_ ? version_(id) : 0;
}

std::vector<Piece> Damage::painted_anew(const std::vector<OpaquePicture>& pictures) {
    std::vector<Piece> anew;
    std::vector<Shown> shown;
    for (const OpaquePicture& picture : pictures) {
        const std::uint64_t version = version_of(picture.texture);
        const auto before = std::ranges::find_if(pictures_, [&](const Shown& s) {
            return s.rect == picture.rect && s.texture == picture.texture;
        });
        // One that was not there has changed the tiles.
        if (before != pictures_.end() && before->version != version) {
            anew.push_back({picture.rect, picture.command});
        }
        shown.push_back({picture.rect, picture.texture, version});
    }
    pictures_ = std::move(shown);
    return anew;
}

std::vector<Piece> Damage::next(const ImDrawData& frame) {
    const int width = static_cast<int>(frame.DisplaySize.x * frame.FramebufferScale.x);
    const int height = static_cast<int>(frame.DisplaySize.y * frame.FramebufferScale.y);
    const std::vector<OpaquePicture> pictures = opaque_pictures(frame, opaque_);
    Tiles tiles(width, height);
    std::size_t number = 0;
    auto picture = pictures.begin();
    for (int n = 0; n < frame.CmdListsCount; ++n) {
        const ImDrawList& list = *frame.CmdLists[n];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const bool own = picture != pictures.end() && picture->command == number;
            if (own) ++picture;
            ++number;
            const ImTextureID id = command.GetTexID();
            // Names and versions are small numbers: each is spread before the other comes in.
            const std::uint64_t texture =
                mixed(mixed(1, reinterpret_cast<std::uintptr_t>(id)), own ? 0 : version_of(id));
            add_command(list, command, frame.DisplayPos, texture, tiles);
        }
    }
    const bool known =
        width == width_px_ && height == height_px_ && tiles.sums.size() == tiles_.size();
    const std::vector<Piece> anew = painted_anew(pictures);
    const auto in_one_anew = [&](const Rect& rect) {
        return std::ranges::any_of(anew, [&](const Piece& p) { return rect.inside(p.rect); });
    };
    std::vector<bool> changed(tiles.sums.size());
    for (std::size_t i = 0; known && i < changed.size(); ++i) {
        changed[i] = tiles.sums[i] != tiles_[i] && !in_one_anew(tiles.rect(i));
    }
    width_px_ = width;
    height_px_ = height;
    tiles_ = std::move(tiles.sums);
    if (!known) return pieces_of({0, 0, width, height}, pictures);
    std::vector<Rect> rects = runs_of(changed, tiles.columns, tiles.rows);
    for (Rect& r : rects) {
        r = {r.x * kTile_px, r.y * kTile_px, r.width * kTile_px, r.height * kTile_px};
        r.width = std::min(r.width, width - r.x);
        r.height = std::min(r.height, height - r.y);
    }
    join(rects);
    std::vector<Piece> pieces = anew;
    for (const Rect& rect : rects) {
        for (const Piece& piece : pieces_of(rect, pictures)) {
            if (!in_one_anew(piece.rect)) pieces.push_back(piece);
        }
    }
    return pieces;
}

namespace {

/// The pixels that Dear ImGui's OpenGL backend lets through: it cuts fractions off, of the height
/// from the lower edge of the picture.
Rect pixels_of(const ImVec4& clip, const ImVec2& origin, int height_px) {
    const auto left = static_cast<int>(clip.x - origin.x);
    const auto from_below = static_cast<int>(static_cast<float>(height_px) - (clip.w - origin.y));
    const auto width = static_cast<int>(clip.z - clip.x);
    const auto height = static_cast<int>(clip.w - clip.y);
    return {left, height_px - from_below - height, width, height};
}

}  // namespace

ClippedFrame::ClippedFrame(const ImDrawData& frame, const Rect& rect, std::size_t first_command)
    : frame_(frame) {
    const auto height_px = static_cast<int>(frame.DisplaySize.y * frame.FramebufferScale.y);
    for (int n = 0; n < frame.CmdListsCount; ++n) {
        for (ImDrawCmd& command : frame.CmdLists[n]->CmdBuffer) {
            own_.push_back(command.ClipRect);
            if (own_.size() <= first_command) {
                command.ClipRect = {frame.DisplayPos.x, frame.DisplayPos.y, frame.DisplayPos.x,
                                    frame.DisplayPos.y};
                continue;
            }
            const Rect own = pixels_of(command.ClipRect, frame.DisplayPos, height_px);
            const int left = std::max(own.x, rect.x);
            const int top = std::max(own.y, rect.y);
            // Where nothing is left the rectangle is empty, never turned around.
            const int right = std::max(left, std::min(own.right(), rect.right()));
            const int bottom = std::max(top, std::min(own.bottom(), rect.bottom()));
            command.ClipRect = {frame.DisplayPos.x + static_cast<float>(left),
                                frame.DisplayPos.y + static_cast<float>(top),
                                frame.DisplayPos.x + static_cast<float>(right),
                                frame.DisplayPos.y + static_cast<float>(bottom)};
        }
    }
}

ClippedFrame::~ClippedFrame() {
    auto own = own_.begin();
    for (int n = 0; n < frame_.CmdListsCount; ++n) {
        for (ImDrawCmd& command : frame_.CmdLists[n]->CmdBuffer) command.ClipRect = *own++;
    }
}

}  // namespace gripscan::ui
