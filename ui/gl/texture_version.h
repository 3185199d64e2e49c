// Which version of its picture a texture holds: so that who shows it knows whether it has changed.
// On the thread of the OpenGL context.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

namespace gripscan::ui {

/// Its pixels are others now.
void note_texture_changed(GLuint texture);
/// Rises with every change; 0: never told of one.
[[nodiscard]] std::uint64_t texture_version(GLuint texture);

}  // namespace gripscan::ui
