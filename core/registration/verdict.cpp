#include "core/registration/verdict.h"

#include <array>
#include <cstddef>

namespace gripscan {

std::string_view word(Verdict verdict) {
    constexpr std::array<std::string_view, 4> kWords{"accept", "check", "reject", "accept_noted"};
    return kWords[static_cast<std::size_t>(verdict)];
}

std::string_view word(Cause cause) {
    constexpr std::array<std::string_view, 17> kWords{
        "none",         "overlap",     "symmetry",         "texture",       "exposure", "settle",
        "wrong_joint",  "ratio",       "backlash",         "sign",          "slip",     "loose",
        "moved_camera", "mislabelled", "depth_distortion", "not_converged", "link"};
    return kWords[static_cast<std::size_t>(cause)];
}

std::string_view word(TurnMode mode) {
    constexpr std::array<std::string_view, 3> kWords{"free", "prior", "axis-locked"};
    return kWords[static_cast<std::size_t>(mode)];
}

std::string_view word(SignSource source) {
    constexpr std::array<std::string_view, 3> kWords{"axis_hint", "joint", "assumed"};
    return kWords[static_cast<std::size_t>(source)];
}

}  // namespace gripscan
