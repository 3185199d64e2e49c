#include "core/procedure/turn_plan.h"

#include <array>

namespace gripscan {

std::string_view word(MotionMode mode) {
    constexpr std::array<std::string_view, 4> kWords{"SIM", "DRY", "LIVE", "MANUAL"};
    return kWords[static_cast<std::size_t>(mode)];
}

}  // namespace gripscan
