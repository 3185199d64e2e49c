#include "app/workstation/frame_times_file.h"

#include <fmt/core.h>

namespace gripscan::app {

Result<FrameTimesFile> FrameTimesFile::make(const std::filesystem::path& file) {
    std::ofstream out(file, std::ios::binary);
    out << "begin_s,own_ms,cpu_ms,swap_ms,clicked,requests\n" << std::flush;
    if (!out) return input_error("{}: cannot be written; choose another file", file.string());
    return FrameTimesFile(std::move(out));
}

void FrameTimesFile::note(const ui::FrameInput& frame, std::size_t requests) {
    if (begun_) {
        out_ << fmt::format("{:.6f},{:.3f},{:.3f},{:.3f},{:d},{}\n", begun_->begin_s,
                            frame.last.own_ms, frame.last.cpu_ms, frame.last.swap_ms,
                            static_cast<int>(begun_->clicked), begun_->requests);
    }
    begun_ = Begun{frame.ui.time_s, frame.clicked, requests};
}

}  // namespace gripscan::app
