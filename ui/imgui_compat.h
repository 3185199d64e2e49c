// What differs between Dear ImGui 1.86, which Debian 12 has, and later releases: in one place, so
// that a newer one can come in.
#pragma once

#include <imgui.h>

#include <cstdint>

namespace gripscan::ui {

/// 1.86: textures are pointers.
[[nodiscard]] inline ImTextureID imgui_texture(unsigned int gl_name) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(gl_name));
}

/// 1.86: no io.Add…Event; a key that is down is a flag at the backend's own key number.
inline void set_key(ImGuiIO& io, ImGuiKey key, bool down) {
    const int backend_key = io.KeyMap[key];
    if (backend_key >= 0) io.KeysDown[backend_key] = down;
}

}  // namespace gripscan::ui
