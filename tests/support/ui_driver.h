// Drives panels and widgets without a window: frames, mouse and keys. The only place that writes
// Dear ImGui's input by hand.
#pragma once

#include <imgui.h>

#include <functional>
#include <memory>
#include <string_view>

#include "ui/shell/imgui_session.h"

namespace gripscan::test {

class UiDriver {
  public:
    using Draw = std::function<void(const ui::Ui&)>;

    /// `draw` is called once a frame, inside a screen of that size.
    UiDriver(int width_px, int height_px, Draw draw, ui::Scale scale = ui::Scale(),
             ui::ThemeChoice theme = ui::ThemeChoice::kDark);

    void frame();
    /// Mouse on the middle of the control, down, up; false if it is not shown.
    bool click(std::string_view id, ImGuiMouseButton which = ImGuiMouseButton_Left);
    bool hover(std::string_view id);
    void mouse(float x, float y);
    void press(ImGuiMouseButton which, bool down);
    void key(ImGuiKey key);
    void type(std::string_view text);

    [[nodiscard]] const ui::WidgetLog& log() const { return log_; }
    [[nodiscard]] ui::ImGuiSession& session() { return *session_; }

  private:
    std::unique_ptr<ui::ImGuiSession> session_;
    ui::WidgetLog log_;
    Draw draw_;
    double time_s_ = 0.0;
};

}  // namespace gripscan::test
