#include "ui/gl/texture_version.h"

#include <unordered_map>

namespace gripscan::ui {
namespace {

/// By name. Names are few and used again: what is deleted needs not be forgotten.
std::unordered_map<GLuint, std::uint64_t>& versions() {
    static std::unordered_map<GLuint, std::uint64_t> all;
    return all;
}

}  // namespace

void note_texture_changed(GLuint texture) {
    ++versions()[texture];
}

std::uint64_t texture_version(GLuint texture) {
    const auto found = versions().find(texture);
    return found == versions().end() ? 0 : found->second;
}

}  // namespace gripscan::ui
