#include "core/procedure/turn_plan.h"

#include "core/robot/kinematics.h"

#include <array>

namespace gripscan {

std::string_view word(MotionMode mode) {
    constexpr std::array<std::string_view, 4> kWords{"SIM", "DRY", "LIVE", "MANUAL"};
    return kWords[static_cast<std::size_t>(mode)];
}

double start_of_turn(const TurnPlan& plan, double standing_joint6_rad) {
    if (plan.start_joint6_rad) return *plan.start_joint6_rad;
    constexpr double kRounding_rad = 1e-4;  // of what a controller reports
    const auto [min_rad, max_rad] = joint_ranges()[5];
    const bool fits = standing_joint6_rad >= min_rad &&
                      standing_joint6_rad + plan.total_rad <= max_rad + kRounding_rad;
    // Without motion rights it is the operator who knows.
    return fits || plan.mode == MotionMode::kManual ? standing_joint6_rad : -0.5 * plan.total_rad;
}

}  // namespace gripscan
