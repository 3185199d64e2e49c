// A GLFW window with an OpenGL 3.3 context, and what happened to it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/shell/input_queue.h"
#include "ui/shell/key_layout.h"

struct GLFWwindow;

namespace gripscan::ui {

class GlfwWindow {
  public:
    [[nodiscard]] static Result<std::unique_ptr<GlfwWindow>> make(const std::string& title,
                                                                  int width_px, int height_px);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    /// What came in since it was last asked.
    struct News {
        bool anything = false;  ///< input, a new size, damage
        bool woken = false;     ///< by another thread
        bool exposed = false;   ///< what the window showed may be lost, or does not fit any more
        std::vector<std::filesystem::path> dropped;
    };
    /// Waits for events, at most that long (0: only looks).
    [[nodiscard]] News wait(double seconds);
    /// What mouse and keyboard have told.
    [[nodiscard]] InputQueue& input() { return input_; }
    /// From any thread.
    static void wake();

    struct Size {
        int width_px;
        int height_px;
    };
    [[nodiscard]] Size framebuffer() const;
    /// As far as the monitor has room for it.
    void resize(Size wanted);
    /// The user cannot make it smaller, as far as the monitor has room for that.
    void keep_at_least(Size smallest);
    /// Of the monitor the window is on.
    [[nodiscard]] float content_scale() const;
    /// Whether the user wants the window closed; asked once, forgotten.
    [[nodiscard]] bool take_close_request();
    void swap();
    /// Of the keyboard's layout as it is now.
    [[nodiscard]] static LetterKeys letters();
    [[nodiscard]] GLFWwindow* handle() const { return window_; }

  private:
    GlfwWindow() = default;
    struct Callbacks;
    GLFWwindow* window_ = nullptr;
    News news_;
    InputQueue input_;
};

}  // namespace gripscan::ui
