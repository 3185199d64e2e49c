#include "ui/render/level_of_detail.h"

#include <algorithm>

namespace gripscan::ui {
namespace {

constexpr double kFewest = 30000.0;
constexpr double kMost = 50e6;

}  // namespace

Slice LevelOfDetail::next(std::size_t total, bool changed) {
    const double from = changed ? 0.0 : drawn_;
    const double part = total > 0 ? std::min(1.0, budget_ / static_cast<double>(total)) : 1.0;
    const Slice slice{from, std::min(1.0, from + part), changed};
    drawn_ = slice.to;
    last_points_ = (slice.to - slice.from) * static_cast<double>(total);
    return slice;
}

void LevelOfDetail::measured(double frame_ms) {
    if (!(frame_ms > 0.0)) return;
    // Only a frame that used its budget tells what fits; shorter ones tell nothing.
    const bool full = last_points_ >= 0.9 * budget_;
    const double ratio = std::clamp(target_ms_ / frame_ms, 0.5, 1.25);
    if (ratio < 1.0 || full) {
        // Down at once, up carefully: a late frame is worse than a thin one.
        const double follow = ratio < 1.0 ? 1.0 : 0.3;
        budget_ = std::clamp(budget_ * (1.0 + follow * (ratio - 1.0)), kFewest, kMost);
    }
}

}  // namespace gripscan::ui
