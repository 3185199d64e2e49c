// Dear ImGui with the theme and type of the window at a scale: without a window, so that tests and
// pictures use the same. One exists at a time, on one thread.
#pragma once

#include <imgui.h>

#include <memory>

#include "core/base/result.h"
#include "ui/fonts/font_set.h"
#include "ui/theme/theme.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

class ImGuiSession {
  public:
    /// Files of Dear ImGui are neither read nor written.
    [[nodiscard]] static Result<std::unique_ptr<ImGuiSession>> make(ThemeChoice theme, Scale scale);
    ~ImGuiSession();
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;

    /// Between frames. A new scale bakes the fonts anew: the painter has to make their texture
    /// again (fonts_changed tells it).
    [[nodiscard]] Status set_scale(Scale scale);
    [[nodiscard]] Status set_theme(ThemeChoice theme);
    /// True once after the fonts were baked.
    [[nodiscard]] bool fonts_changed() { return std::exchange(fonts_changed_, false); }

    [[nodiscard]] Scale scale() const { return scale_; }
    [[nodiscard]] const Theme& theme() const { return theme_; }

    /// What widgets of the coming frame get. `log` is cleared.
    [[nodiscard]] Ui frame_ui(WidgetLog& log, double time_s) const;

  private:
    ImGuiSession();
    Status bake(Scale scale);

    ImGuiContext* context_;
    Theme theme_;
    FontSet fonts_;
    Scale scale_;
    bool fonts_changed_ = false;
};

/// A window of Dear ImGui that fills the screen and takes no decoration: panels draw inside.
void begin_screen(const Ui& ui, const Colour& background);
void end_screen();

}  // namespace gripscan::ui
