#include "ui/shell/imgui_feed.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <algorithm>

namespace gripscan::ui {

struct ImGuiFeed::Give {
    ImGuiFeed& self;
    void operator()(const input::Cursor& e) const { self.cursor_ = e; }
    void operator()(const input::Entered& e) const {
        ImGui_ImplGlfw_CursorEnterCallback(self.window_, e.inside ? 1 : 0);
    }
    void operator()(const input::Focus& e) const {
        ImGui_ImplGlfw_WindowFocusCallback(self.window_, e.focused ? 1 : 0);
    }
    void operator()(const input::Button& e) const {
        const auto which = static_cast<std::size_t>(e.button);
        if (which < self.buttons_.size()) self.buttons_[which] = e.down;
    }
    void operator()(const input::Wheel& e) const {
        ImGui_ImplGlfw_ScrollCallback(self.window_, e.dx, e.dy);
    }
    void operator()(const input::Key& e) const {
        ImGui_ImplGlfw_KeyCallback(self.window_, e.key, e.scancode, e.down ? 1 : 0, e.mods);
    }
    void operator()(const input::Typed& e) const {
        ImGui_ImplGlfw_CharCallback(self.window_, e.character);
    }
};

void ImGuiFeed::give(std::span<const InputEvent> events) {
    for (const InputEvent& event : events) std::visit(Give{*this}, event);
    ImGuiIO& io = ImGui::GetIO();
    std::ranges::copy(buttons_, std::begin(io.MouseDown));
    if (cursor_ && ImGui::IsMousePosValid(&io.MousePos)) {
        io.MousePos = {static_cast<float>(cursor_->x), static_cast<float>(cursor_->y)};
    }
}

}  // namespace gripscan::ui
