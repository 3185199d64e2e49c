// Which toasts are shown, and for how long. Pure: the panel that shows them only draws.
#pragma once

#include <vector>

#include "ui/widgets/notices.h"

namespace gripscan::ui {

class ToastQueue {
  public:
    /// A toast with the id of one that is shown replaces it and stays anew.
    void add(Toast toast, double now_s);
    /// Takes away what has been shown long enough.
    void forget_old(double now_s);
    void close(std::string_view id);

    /// The latest last; never more than kMost, of which the oldest go first.
    [[nodiscard]] const std::vector<Toast>& shown() const { return toasts_; }
    /// When the next one goes, for the timer of the next frame; infinity if none is shown.
    [[nodiscard]] double next_end_s() const;

    static constexpr double kShown_s = 6.0;
    static constexpr std::size_t kMost = 4;

  private:
    std::vector<Toast> toasts_;
    std::vector<double> ends_s_;  ///< one a toast
};

}  // namespace gripscan::ui
