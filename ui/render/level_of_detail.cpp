#include "ui/render/level_of_detail.h"

#include <algorithm>

namespace gripscan::ui {
namespace {

constexpr double kFewest = 5000.0;
constexpr double kMost = 50e6;
/// A still view may take this much longer a frame: nobody waits for it.
constexpr double kStillFactor = 1.5;

}  // namespace

Slice LevelOfDetail::next(std::size_t total, bool changed) {
    const bool anew = changed || coarse_;
    const double from = anew ? 0.0 : drawn_;
    const double points = changed ? budget_ : kStillFactor * budget_;
    const double part = total > 0 ? std::min(1.0, points / static_cast<double>(total)) : 1.0;
    Slice slice{from, std::min(1.0, from + part), anew, false};
    slice.coarse = coarse_ = changed && slice.to < 1.0;
    drawn_ = slice.coarse ? 0.0 : slice.to;
    last_points_ = changed ? slice.to * static_cast<double>(total) : 0.0;
    return slice;
}

void LevelOfDetail::measured(double frame_ms) {
    if (!(frame_ms > 0.0) || last_points_ <= 0.0) return;
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
