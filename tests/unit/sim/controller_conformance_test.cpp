// The simulated controller keeps to the protocol, as the conformance script sees it.
#include <gtest/gtest.h>

#include "core/robot/robot_conformance.h"
#include "tests/unit/sim/served_cabinet.h"

namespace gripscan::sim {
namespace {

TEST(ControllerConformance, TheSimulatedControllerPassesEveryCheckWithMotion) {
    ServedCabinet served({}, 5.0);
    gsp::ConformanceSettings settings;
    settings.motion_port = served.motion.port();
    settings.monitor_port = served.monitor.port();
    settings.move = true;
    const auto report = gsp::check_conformance(settings, {}, {});
    ASSERT_TRUE(report) << report.error().message;
    for (const auto& check : report->checks) {
        const bool fine = check.outcome == gsp::CheckOutcome::kPassed ||
                          check.outcome == gsp::CheckOutcome::kNoted;
        EXPECT_TRUE(fine) << check.name << " " << name_of(check.outcome) << ": " << check.seen;
    }
    EXPECT_NEAR(served.cabinet.arm().encoder_rad[5], 0.0, rad_from_deg(0.05));
}

}  // namespace
}  // namespace gripscan::sim
