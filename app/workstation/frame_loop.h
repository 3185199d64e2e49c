// One frame of the window: take in what came, show it, take what was asked for.
#pragma once

#include <memory>
#include <optional>

#include "app/workstation/frame_times_file.h"
#include "app/workstation/widget_list.h"
#include "app/workstation/window_options.h"
#include "app/workstation/workstation.h"
#include "ui/panels/screen.h"
#include "ui/shell/app_window.h"
#include "ui/shell/script_player.h"

namespace gripscan::app {

class FrameLoop {
  public:
    /// `window` and `station` outlive it.
    FrameLoop(ui::AppWindow& window, Workstation& station, const WindowOptions& options,
              std::optional<ui::ScriptPlayer> player);
    /// What is drawn with OpenGL, and the file of frame times. Errors: the card cannot do it, the
    /// file cannot be written.
    [[nodiscard]] Status make_views();

    [[nodiscard]] ui::FrameWish frame(const ui::FrameInput& input);
    /// Why the script or a picture failed.
    [[nodiscard]] std::optional<std::string> trouble() const;

  private:
    /// To the workstation, after the panels' own state was made ready for it.
    void pass_on(const ui::Request& request);
    /// What only the panels' own state can hold of a request.
    void prepare_for(const ui::Request& request);
    void take_window_wish(const WindowWish& wish);
    void apply_preferences();
    /// Of this frame; the whole window, or a part of it.
    void take_picture(const std::filesystem::path& file,
                      const std::optional<ui::Rect>& part = std::nullopt);
    /// Beside the session, under its name; nothing that is there is overwritten.
    [[nodiscard]] std::filesystem::path picture_file(const std::string& ending) const;

    ui::AppWindow& window_;
    Workstation& station_;
    const WindowOptions& options_;
    std::optional<ui::ScriptPlayer> player_;
    std::optional<WidgetList> widgets_;
    std::optional<FrameTimesFile> times_;
    ui::ScreenState screen_;
    ui::ScreenParts parts_;
    ui::WindowPreferences applied_;
    bool view_picture_ = false;  ///< the 3D view is to be photographed once it is drawn whole
    std::size_t frames_ = 0;
    std::optional<std::string> picture_trouble_;
};

/// The guided demonstration: a script that comes with the program.
[[nodiscard]] Result<ui::ScriptPlayer> guided_tour();

}  // namespace gripscan::app
