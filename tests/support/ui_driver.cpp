#include "tests/support/ui_driver.h"

#include <stdexcept>

#include "ui/imgui_compat.h"

namespace gripscan::test {

UiDriver::UiDriver(int width_px, int height_px, Draw draw, ui::Scale scale, ui::ThemeChoice theme)
    : draw_(std::move(draw)) {
    auto session = ui::ImGuiSession::make(theme, scale);
    if (!session) throw std::runtime_error(session.error().message);
    session_ = *std::move(session);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width_px), static_cast<float>(height_px)};
    io.DeltaTime = 1.0F / 60.0F;
    for (int i = 0; i < ImGuiKey_COUNT; ++i) io.KeyMap[i] = i;
}

void UiDriver::frame() {
    ImGui::NewFrame();
    const ui::Ui ui = session_->frame_ui(log_, time_s_);
    ui::begin_screen(ui, ui.theme.panel);
    draw_(ui);
    ui::end_screen();
    ImGui::Render();
    time_s_ += static_cast<double>(ImGui::GetIO().DeltaTime);
}

void UiDriver::mouse(float x, float y) {
    ImGui::GetIO().MousePos = {x, y};
    frame();
}

void UiDriver::press(ImGuiMouseButton which, bool down) {
    ImGui::GetIO().MouseDown[which] = down;
    frame();
}

bool UiDriver::hover(std::string_view id) {
    frame();
    const auto control = log_.find(id);
    if (!control || control->rect.empty()) return false;
    mouse(static_cast<float>(control->rect.x) + 0.5F * static_cast<float>(control->rect.width),
          static_cast<float>(control->rect.y) + 0.5F * static_cast<float>(control->rect.height));
    frame();
    return true;
}

bool UiDriver::click(std::string_view id, ImGuiMouseButton which) {
    if (!hover(id)) return false;
    press(which, true);
    press(which, false);
    return true;
}

void UiDriver::key(ImGuiKey key) {
    ImGuiIO& io = ImGui::GetIO();
    ui::set_key(io, key, true);
    frame();
    ui::set_key(io, key, false);
    frame();
}

void UiDriver::type(std::string_view text) {
    ImGui::GetIO().AddInputCharactersUTF8(std::string(text).c_str());
    frame();
}

}  // namespace gripscan::test
