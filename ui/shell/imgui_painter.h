// Draws what Dear ImGui collected with OpenGL, into the bound framebuffer.
#pragma once

#include <memory>

#include "core/base/result.h"

namespace gripscan::ui {

/// Needs a current OpenGL 3.3 context and an ImGuiSession, from the beginning to the end.
class ImGuiPainter {
  public:
    [[nodiscard]] static Result<std::unique_ptr<ImGuiPainter>> make();
    ~ImGuiPainter();
    ImGuiPainter(const ImGuiPainter&) = delete;
    ImGuiPainter& operator=(const ImGuiPainter&) = delete;

    /// Before ImGui::NewFrame; `fonts_changed` when the atlas was baked anew.
    void begin_frame(bool fonts_changed);
    /// After ImGui::Render.
    void paint();

  private:
    ImGuiPainter() = default;
};

}  // namespace gripscan::ui
