#include "app/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include "app/standard_streams.h"

namespace gripscan::app {
namespace {

constexpr std::size_t kCells = 28;
constexpr auto kBetweenDrawings = std::chrono::milliseconds(50);

}  // namespace

ProgressBar::ProgressBar(const Context& context)
    : stop_(context.stop), visible_(!context.options.quiet && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    end_line();
}

Progress ProgressBar::progress() {
    Progress progress{stop_, {}};
    if (visible_) {
        progress.report = [this](std::string_view stage, std::size_t done, std::size_t total) {
            show(stage, done, total);
        };
    }
    return progress;
}

void ProgressBar::show(std::string_view stage, std::size_t done, std::size_t total) {
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    if (stage != stage_) {
        end_line();
        stage_ = stage;
        began_ = now;
        done_ = 0;
    } else if (done < done_ || (done < total && now - drawn_ < kBetweenDrawings)) {
        return;  // a slower thread's news, or too soon to be seen
    }
    done_ = done;
    drawn_ = now;
    const std::size_t full = total > 0 ? kCells * std::min(done, total) / total : 0;
    const double seconds = std::chrono::duration<double>(now - began_).count();
    tell_people(fmt::format("\r{:<18} [{:#<{}}{:.<{}}] {:>4}/{:<4} {:6.1f} s ", stage_, "", full,
                            "", kCells - full, done, total, seconds));
}

void ProgressBar::end_line() {
    if (!stage_.empty()) tell_people("\n");
    stage_.clear();
}

}  // namespace gripscan::app
