// The turn that the fault tests make.
#pragma once

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/robot/robot_link.h"
#include "tests/support/mock_controller.h"

namespace gripscan::gsp {

inline constexpr double kTarget_deg = 20.0;
inline const Joint6Command kTurn{17, rad_from_deg(kTarget_deg), 10.0};
inline const Joint6Command kNext{18, rad_from_deg(2 * kTarget_deg), 10.0};

/// More often than a test exchanges anything.
inline constexpr int kForEver = 100000;

/// Half a unit of the fourth decimal.
inline constexpr double kRounding_rad = rad_from_deg(5e-5);

inline void expect_arrived(const RobotResult<RobotReading>& outcome,
                           test::MockController& controller) {
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_NEAR(outcome->joints_rad[5], kTurn.angle_rad, kRounding_rad);
    EXPECT_NEAR(controller.arm().travelled_deg(), kTarget_deg, 1e-9) << "no way is gone twice";
}

}  // namespace gripscan::gsp
