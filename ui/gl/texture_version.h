// Which version of its picture a texture holds: so that who shows it knows whether it has changed.
// On the thread of the OpenGL context.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

namespace gripscan::ui {

/// Whether what lies under a picture can be seen through it.
enum class SeenThrough { kNo, kYes };

/// Its pixels are others now.
void note_texture_changed(GLuint texture, SeenThrough seen_through);
/// Rises with every change; 0: never told of one.
[[nodiscard]] std::uint64_t texture_version(GLuint texture);
/// False too for a texture of which nothing is known.
[[nodiscard]] bool texture_opaque(GLuint texture);

}  // namespace gripscan::ui
