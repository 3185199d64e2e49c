// What happens beside the work: toasts, which never take the focus, and jobs with their progress.
#pragma once

#include <string>
#include <string_view>

#include "ui/widgets/state_shape.h"

namespace gripscan::ui {

struct Toast {
    std::string id;  ///< "toast.exported"
    State state = State::kAccept;
    std::string title;
    std::string text;    ///< second line
    std::string action;  ///< a link at the right; empty: none
};

/// Returns true when the action was clicked. The height is toast_height.
[[nodiscard]] bool draw_toast(const Ui& ui, const Rect& rect, const Toast& toast);
[[nodiscard]] int toast_height(const Ui& ui);

struct Job {
    std::string_view id;    ///< "job.joint"
    std::string_view name;  ///< empty in a narrow status bar
    double part = 0.0;  ///< 0 … 1; below 0: unknown
    double elapsed_s = 0.0;
    bool can_cancel = true;
};

/// In one line from `x`; returns true when Cancel was clicked. `end_x` is where it ends.
[[nodiscard]] bool job_bar(const Ui& ui, int x, float y, const Job& job, int* end_x = nullptr);
[[nodiscard]] int job_bar_width(const Ui& ui, const Job& job);

/// Words that can be clicked.
[[nodiscard]] bool link(const Ui& ui, const Rect& rect, std::string_view id, std::string_view label,
                        Icon icon = Icon::kNone);

}  // namespace gripscan::ui
