// How many points are drawn: while the view moves as many as fit into a frame's time, somewhat
// larger; once it stands still all of them, slice by slice, beside the coarse picture, so that the
// finished one does not depend on how it came about. The points of a chunk are in random order:
// every slice is an even sample.
#pragma once

#include <cstddef>

namespace gripscan::ui {

/// Points [from, to) of every chunk as parts 0 … 1 of its size.
struct Slice {
    double from = 0.0;
    double to = 0.0;
    bool clear = false;   ///< the picture begins anew
    bool coarse = false;  ///< only a sample, for a moving view

    /// Indices of a chunk of `size` points: neighbouring slices meet without gap or overlap.
    [[nodiscard]] std::size_t first(std::size_t size) const {
        return static_cast<std::size_t>(from * static_cast<double>(size));
    }
    [[nodiscard]] std::size_t end(std::size_t size) const {
        return static_cast<std::size_t>(to * static_cast<double>(size));
    }
    [[nodiscard]] bool empty() const { return to <= from; }
};

class LevelOfDetail {
  public:
    /// Half of what a frame may take at most: it takes twice as long when the processor is shared.
    static constexpr double kTarget_ms = 16.0;

    explicit LevelOfDetail(double target_ms = kTarget_ms) : target_ms_(target_ms) {}

    /// What the coming frame draws of `total` points. `changed`: camera, points or colours are not
    /// those of the frame before.
    [[nodiscard]] Slice next(std::size_t total, bool changed);
    /// The time the whole frame took in which that slice was drawn: the budget follows it.
    void measured(double frame_ms);

    /// Nothing is left to draw: no frame is needed.
    [[nodiscard]] bool complete() const { return drawn_ >= 1.0; }
    /// Points a frame may draw.
    [[nodiscard]] std::size_t budget() const { return static_cast<std::size_t>(budget_); }

  private:
    double target_ms_;
    double budget_ = 300000.0;
    double drawn_ = 1.0;        ///< part of the points that the picture holds
    bool coarse_ = false;       ///< the picture is a sample: the full one has not begun
    double last_points_ = 0.0;  ///< of the last moving frame; 0 after a still one
};

}  // namespace gripscan::ui
