#include "ui/shell/imgui_session.h"

#include "ui/theme/imgui_style.h"
#include "ui/widgets/draw.h"

namespace gripscan::ui {

ImGuiSession::ImGuiSession() : context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.ConfigInputTextCursorBlink = true;
}

ImGuiSession::~ImGuiSession() {
    ImGui::DestroyContext(context_);
}

Result<std::unique_ptr<ImGuiSession>> ImGuiSession::make(ThemeChoice theme, Scale scale) {
    std::unique_ptr<ImGuiSession> session(new ImGuiSession());
    if (auto baked = session->bake(scale); !baked) return forward_error(baked.error());
    if (auto set = session->set_theme(theme); !set) return forward_error(set.error());
    return session;
}

Status ImGuiSession::bake(Scale scale) {
    auto fonts = FontSet::bake(*ImGui::GetIO().Fonts, scale);
    if (!fonts) return forward_error(fonts.error());
    fonts_ = *fonts;
    scale_ = scale;
    fonts_changed_ = true;
    return {};
}

Status ImGuiSession::set_scale(Scale scale) {
    if (scale == scale_) return {};
    if (auto baked = bake(scale); !baked) return baked;
    ImGui::GetStyle() = imgui_style(theme_, scale_);
    return {};
}

Status ImGuiSession::set_theme(ThemeChoice choice) {
    auto theme = load_theme(choice);
    if (!theme) return forward_error(theme.error());
    theme_ = *std::move(theme);
    ImGui::GetStyle() = imgui_style(theme_, scale_);
    return {};
}

Ui ImGuiSession::frame_ui(WidgetLog& log, double time_s) const {
    log.begin_frame();
    return {theme_, fonts_, scale_, log, time_s};
}

void begin_screen(const Ui&, const Colour& background) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(size);
    ImGui::Begin("###screen", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoSavedSettings);
    fill({0, 0, static_cast<int>(size.x), static_cast<int>(size.y)}, background);
}

void end_screen() {
    ImGui::End();
}

}  // namespace gripscan::ui
