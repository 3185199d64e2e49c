#include "ui/shell/imgui_painter.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

namespace gripscan::ui {

Result<std::unique_ptr<ImGuiPainter>> ImGuiPainter::make() {
    if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
        return device_error(
            "OpenGL 3.3 cannot be used for the window; is a graphics driver (or "
            "libgl1-mesa-dri) installed?");
    }
    return std::unique_ptr<ImGuiPainter>(new ImGuiPainter());
}

ImGuiPainter::~ImGuiPainter() {
    ImGui_ImplOpenGL3_Shutdown();
}

void ImGuiPainter::begin_frame(bool fonts_changed) {
    ImGui_ImplOpenGL3_NewFrame();
    if (!fonts_changed) return;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void ImGuiPainter::paint() {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace gripscan::ui
