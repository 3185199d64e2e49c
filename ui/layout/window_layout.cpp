#include "ui/layout/window_layout.h"

namespace gripscan::ui {
namespace {

// Lengths in px at 100 %.
constexpr float kTopBar = 40.0F;
constexpr float kStageBar = 54.0F;
constexpr float kStageBarOneLine = 36.0F;
constexpr float kStatusBar = 30.0F;
constexpr float kSplitter = 4.0F;
constexpr float kViewMinWidth = 480.0F;
constexpr float kViewMinHeight = 360.0F;
constexpr float kBottomMinHeight = 172.0F;
constexpr float kHistoryMinHeight = 132.0F;  // the plot
constexpr float kCardHeight = 578.0F;        // it never scrolls: dial, verdict, evidence, buttons
constexpr float kCardHeightSmall = 540.0F;
struct Range {
    float min;
    float max;
};
constexpr Range kStereoWidth{264.0F, 480.0F};
constexpr Range kRightWidth{336.0F, 460.0F};

// Logical sizes (px / scale) from which a layout applies.
constexpr float kFullWidth = 1600.0F;
constexpr float kFullHeight = 1000.0F;
constexpr float kStereoMinWidth = 1120.0F;
constexpr float kStereoMinHeight = 700.0F;

struct Logical {
    float width;
    float height;
};

Logical logical_size(int width_px, int height_px, Scale scale) {
    return {static_cast<float>(width_px) / scale.factor(),
            static_cast<float>(height_px) / scale.factor()};
}

Detail detail_of(const Logical& size) {
    Detail detail;
    const bool full = size.width >= kFullWidth && size.height >= kFullHeight;
    detail.stage_criteria = full;
    detail.tool_labels = full;
    detail.button_icons = full;
    detail.log_is_a_tab = !full;
    detail.full_right_column = !full;
    detail.stereo_is_a_tab = size.width < kStereoMinWidth || size.height < kStereoMinHeight;
    return detail;
}

float clamped(float value, Range range) {
    // A value that is no number compares false and ends at the minimum.
    return value >= range.min ? std::min(value, range.max) : range.min;
}

/// The splits as far as a window allows them: the 3D view keeps its minimum first, then the columns
/// theirs.
Splits allowed(const Splits& wanted, const Logical& size, const Detail& detail) {
    Splits splits;
    splits.right_width = clamped(wanted.right_width, kRightWidth);
    splits.stereo_width =
        detail.stereo_is_a_tab ? 0.0F : clamped(wanted.stereo_width, kStereoWidth);
    const float stage = detail.stage_criteria ? kStageBar : kStageBarOneLine;
    const float splitters = detail.stereo_is_a_tab ? kSplitter : 2.0F * kSplitter;
    float missing =
        kViewMinWidth + splitters + splits.stereo_width + splits.right_width - size.width;
    if (missing > 0.0F && !detail.stereo_is_a_tab) {
        const float given = std::min(missing, splits.stereo_width - kStereoWidth.min);
        splits.stereo_width -= given;
        missing -= given;
    }
    if (missing > 0.0F) {
        splits.right_width -= std::min(missing, splits.right_width - kRightWidth.min);
    }
    const float middle = size.height - kTopBar - stage - kStatusBar - kSplitter;
    const float above = detail.full_right_column ? kViewMinHeight : kCardHeight;
    const float most = std::max(kBottomMinHeight, std::min(0.6F * size.height, middle - above));
    splits.bottom_height = clamped(wanted.bottom_height, {kBottomMinHeight, most});
    return splits;
}

int whole(float px, int room) {
    return std::clamp(static_cast<int>(px), 0, std::max(0, room));
}

/// The part between stage bar and status bar.
void lay_out_middle(WindowLayout& l, const Splits& splits, const Rect& middle, Scale scale) {
    const int splitter = whole(scale.px(kSplitter), std::min(middle.width, middle.height));
    const int right = whole(scale.px(splits.right_width), middle.width - splitter);
    const int left_part = middle.width - right - splitter;
    l.splitter_right = {middle.x + left_part, middle.y, splitter, middle.height};

    const int bottom = whole(scale.px(splits.bottom_height), middle.height - splitter);
    const int top = middle.height - bottom - splitter;
    const int dock_y = middle.y + top + splitter;
    l.table = {middle.x, dock_y, left_part, bottom};
    l.splitter_bottom = {middle.x, middle.y + top, left_part, splitter};

    const int stereo =
        l.detail.stereo_is_a_tab ? 0 : whole(scale.px(splits.stereo_width), left_part - splitter);
    const int gap = l.detail.stereo_is_a_tab ? 0 : splitter;
    l.stereo = {middle.x, middle.y, stereo, stereo > 0 ? top : 0};
    l.splitter_stereo = {middle.x + stereo, middle.y, gap, gap > 0 ? top : 0};
    l.view3d = {middle.x + stereo + gap, middle.y, left_part - stereo - gap, top};

    const int column = middle.x + left_part + splitter;
    if (!l.detail.full_right_column) {
        l.step_card = {column, middle.y, right, top};
        l.history = {column, dock_y, right, bottom};
        return;
    }
    int card = whole(scale.px(kCardHeightSmall), middle.height);
    if (middle.height - card - splitter < static_cast<int>(scale.px(kHistoryMinHeight))) {
        card = middle.height;  // the plot gives way, never a button
    }
    l.step_card = {column, middle.y, right, card};
    const int below = card + splitter;
    if (card < middle.height) {
        l.history = {column, middle.y + below, right, middle.height - below};
    }
}

}  // namespace

Splits default_splits(int width_px, int height_px, Scale scale) {
    const Logical size = logical_size(width_px, height_px, scale);
    if (size.width < kFullWidth || size.height < kFullHeight) return {264.0F, 336.0F, 226.0F};
    if (size.width >= 2400.0F && size.height >= 1350.0F) return {420.0F, 456.0F, 480.0F};
    return {};
}

WindowLayout layout_window(int width_px, int height_px, const Splits& splits, Scale scale) {
    const int width = std::max(0, width_px);
    const int height = std::max(0, height_px);
    const Logical size = logical_size(width, height, scale);
    WindowLayout l;
    l.detail = detail_of(size);
    int left = height;  // what the bars have not taken yet; the status bar comes first
    const auto take = [&](float px) {
        const int taken = whole(scale.px(px), left);
        left -= taken;
        return taken;
    };
    const int status = take(kStatusBar);
    l.top_bar = {0, 0, width, take(kTopBar)};
    l.stage_bar = {0, l.top_bar.height, width,
                   take(l.detail.stage_criteria ? kStageBar : kStageBarOneLine)};
    l.status_bar = {0, height - status, width, status};
    const Rect middle{0, l.stage_bar.bottom(), width, left};
    lay_out_middle(l, allowed(splits, size, l.detail), middle, scale);
    return l;
}

Splits dragged(const Splits& splits, Splitter splitter, int by_px, int width_px, int height_px,
               Scale scale) {
    const Logical size = logical_size(width_px, height_px, scale);
    const Detail detail = detail_of(size);
    const float by = static_cast<float>(by_px) / scale.factor();
    Splits moved = allowed(splits, size, detail);
    if (splitter == Splitter::kStereo) moved.stereo_width += by;
    if (splitter == Splitter::kRight) moved.right_width -= by;
    if (splitter == Splitter::kBottom) moved.bottom_height -= by;
    moved = allowed(moved, size, detail);
    // The column behind its tab keeps the width it had.
    if (detail.stereo_is_a_tab) moved.stereo_width = splits.stereo_width;
    return moved;
}

}  // namespace gripscan::ui
