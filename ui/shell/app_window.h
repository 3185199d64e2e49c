// The window on the screen: GLFW, Dear ImGui and OpenGL put together. Frames are drawn on events,
// on request and on timers, and not otherwise, so that an idle window costs nothing.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/theme/theme.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct WindowSettings {
    std::string title = "gripscan";
    int width_px = 1600;
    int height_px = 1000;
    ThemeChoice theme = ThemeChoice::kDark;
    float user_scale = 1.0F;  ///< times the monitor's content scale
};

/// Where the time of a frame went.
struct FrameTimes {
    double own_ms = 0.0;   ///< panels and drawing, as far as the processor did it
    double cpu_ms = 0.0;   ///< processor time of this thread for them
    double swap_ms = 0.0;  ///< handing the picture over; a software rasteriser finishes here
    [[nodiscard]] double total_ms() const { return own_ms + swap_ms; }
};

/// What a frame gets.
struct FrameInput {
    const Ui& ui;
    int width_px;
    int height_px;
    FrameTimes last;                             ///< of the frame before
    bool clicked;                                ///< a mouse button was let go
    bool close_requested;                        ///< the user closes the window: FrameWish says
    std::vector<std::filesystem::path> dropped;  ///< files dropped on the window since then
};

/// What a frame asks for.
struct FrameWish {
    double redraw_after_s = std::numeric_limits<double>::infinity();  ///< 0: at once
    bool close = false;
};

class AppWindow {
  public:
    using Frame = std::function<FrameWish(const FrameInput&)>;
    using Capture =
        std::function<void(int width_px, int height_px, std::vector<std::uint8_t> rgba)>;

    /// On the main thread, one at a time. Fails where there is no screen or no OpenGL 3.3.
    [[nodiscard]] static Result<std::unique_ptr<AppWindow>> make(const WindowSettings& settings);
    ~AppWindow();
    AppWindow(const AppWindow&) = delete;
    AppWindow& operator=(const AppWindow&) = delete;

    /// Draws frames until one of them asks for the end, or `most_frames` were drawn (0: no limit).
    /// In that last case frames follow each other without waiting.
    [[nodiscard]] Status run(const Frame& frame, std::size_t most_frames = 0);

    /// From any thread: something new is to be shown.
    static void request_redraw();
    /// The next frame's picture, RGBA rows from top to bottom.
    void capture_next(Capture capture);
    /// Called before every frame with the controls of the one before; may set Dear ImGui's input.
    void before_frames(std::function<void(const WidgetLog& shown, double now_s)> set_input);
    /// Take effect before the next frame. The factor is kept in [0.5, 4] with the monitor's.
    void set_user_scale(float factor);
    void set_theme(ThemeChoice theme);
    void set_large_buttons(bool on);
    void copy_to_clipboard(const std::string& text);

    [[nodiscard]] std::size_t frames_drawn() const;
    /// The controls of the last frame, by name.
    [[nodiscard]] const WidgetLog& widgets() const;

  private:
    AppWindow();
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace gripscan::ui
