// How long each frame of the window took, as a table: for whoever measures how fluid it is.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>

#include "core/base/result.h"
#include "ui/shell/app_window.h"

namespace gripscan::app {

/// CSV with one line a frame: begin_s, own_ms (panels and drawing), cpu_ms (of this thread, for
/// them), swap_ms (handing the picture over), clicked (a mouse button was let go: 0 or 1), requests
/// (what the frame asked the workstation for). The last frame, not yet over, has no line.
class FrameTimesFile {
  public:
    /// Errors: the file cannot be written.
    [[nodiscard]] static Result<FrameTimesFile> make(const std::filesystem::path& file);
    void note(const ui::FrameInput& frame, std::size_t requests);

  private:
    explicit FrameTimesFile(std::ofstream out) : out_(std::move(out)) {}
    struct Begun {
        double begin_s;
        bool clicked;
        std::size_t requests;
    };
    std::ofstream out_;
    std::optional<Begun> begun_;  ///< its times are known with the next frame
};

}  // namespace gripscan::app
