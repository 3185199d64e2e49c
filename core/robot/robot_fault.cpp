#include <array>

#include "core/robot/robot_link.h"

namespace gripscan {

std::string_view word(RobotFault fault) {
    constexpr std::array<std::string_view, 11> kWords{
        "unreachable", "lost",    "timeout",    "protocol",    "refused", "out_of_range",
        "stale_id",    "stopped", "off_target", "other_joint", "internal"};
    return kWords[static_cast<std::size_t>(fault)];
}

}  // namespace gripscan
