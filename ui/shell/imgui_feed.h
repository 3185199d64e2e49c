// Hands the input of a frame to Dear ImGui.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "ui/shell/input_queue.h"

struct GLFWwindow;

namespace gripscan::ui {

class ImGuiFeed {
  public:
    explicit ImGuiFeed(GLFWwindow* window = nullptr) : window_(window) {}
    /// After the backend's own NewFrame, which asks the mouse where it is now.
    void give(std::span<const InputEvent> events);

  private:
    struct Give;
    GLFWwindow* window_;
    std::optional<input::Cursor> cursor_;  ///< nothing: it has not moved yet
    std::array<bool, 5> buttons_{};
};

}  // namespace gripscan::ui
