#include "ui/gl/texture_version.h"

#include <unordered_map>

namespace gripscan::ui {
namespace {

struct Known {
    std::uint64_t version = 0;
    SeenThrough seen_through = SeenThrough::kYes;
};

/// By name. Names are few and used again: what is deleted needs not be forgotten.
std::unordered_map<GLuint, Known>& textures() {
    static std::unordered_map<GLuint, Known> all;
    return all;
}

Known known(GLuint texture) {
    const auto found = textures().find(texture);
    return found == textures().end() ? Known{} : found->second;
}

}  // namespace

void note_texture_changed(GLuint texture, SeenThrough seen_through) {
    Known& one = textures()[texture];
    ++one.version;
    one.seen_through = seen_through;
}

std::uint64_t texture_version(GLuint texture) {
    return known(texture).version;
}

bool texture_opaque(GLuint texture) {
    return known(texture).seen_through == SeenThrough::kNo;
}

}  // namespace gripscan::ui
