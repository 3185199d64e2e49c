#include "ui/widgets/toast_queue.h"

#include <algorithm>
#include <limits>

namespace gripscan::ui {

void ToastQueue::add(Toast toast, double now_s) {
    close(toast.id);
    toasts_.push_back(std::move(toast));
    ends_s_.push_back(now_s + kShown_s);
    if (toasts_.size() > kMost) {
        toasts_.erase(toasts_.begin());
        ends_s_.erase(ends_s_.begin());
    }
}

void ToastQueue::forget_old(double now_s) {
    // Every toast is shown equally long, so the oldest stand first.
    while (!ends_s_.empty() && ends_s_.front() <= now_s) {
        toasts_.erase(toasts_.begin());
        ends_s_.erase(ends_s_.begin());
    }
}

void ToastQueue::close(std::string_view id) {
    const auto found =
        std::find_if(toasts_.begin(), toasts_.end(), [&](const Toast& t) { return t.id == id; });
    if (found == toasts_.end()) return;
    ends_s_.erase(ends_s_.begin() + (found - toasts_.begin()));
    toasts_.erase(found);
}

double ToastQueue::next_end_s() const {
    return ends_s_.empty() ? std::numeric_limits<double>::infinity() : ends_s_.front();
}

}  // namespace gripscan::ui
