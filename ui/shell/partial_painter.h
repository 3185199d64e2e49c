// Draws only what has changed since the last frame: into a picture of its own that the window then
// shows, or into the window itself where that keeps what it showed.
#pragma once

#include <optional>

#include "ui/gl/render_target.h"
#include "ui/shell/damage.h"
#include "ui/shell/imgui_painter.h"

namespace gripscan::ui {

class PartialPainter {
  public:
    explicit PartialPainter(std::unique_ptr<ImGuiPainter> painter);

    /// Before ImGui::NewFrame; `fonts_changed` when the atlas was baked anew.
    void begin_frame(bool fonts_changed);
    /// After ImGui::Render: brings the picture up to date; false: nothing in it has changed. Fails
    /// where the driver refuses a picture of the window's size.
    [[nodiscard]] Result<bool> paint(int width_px, int height_px);
    /// Brings the picture into the window's framebuffer, if it is not there.
    void show() const;

  private:
    std::unique_ptr<ImGuiPainter> painter_;
    Damage damage_;
    /// Mesa's software rasterisers copy the back buffer to the screen and leave it as it is; to
    /// copy a picture into it first would take them longer than most frames.
    bool window_keeps_;
    std::optional<RenderTarget> picture_;  ///< where the window does not
};

}  // namespace gripscan::ui
