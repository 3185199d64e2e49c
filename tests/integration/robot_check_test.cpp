#include <gmock/gmock.h>

#include "tests/integration/program.h"
#include "tests/support/mock_bends.h"
#include "tests/support/mock_controller.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;

Arguments check_of(const MockController& controller, const Arguments& options = {}) {
    Arguments arguments{"robot-check", "127.0.0.1:" + std::to_string(controller.motion_port()),
                        "--monitor-port", std::to_string(controller.monitor_port())};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
}

TEST(RobotCheck, AConformingControllerIsStatusZeroAndOneLineACheck) {
    MockController controller;
    const auto result = run_program(check_of(controller));
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("passed   hello.motion     OK HELLO LRMate200iC/5L 6"));
    EXPECT_THAT(result.out, HasSubstr("skipped  move.turn        no motion without --move"));
    EXPECT_EQ(controller.arm().moves(), 0);
}

TEST(RobotCheck, MovesWhereItMayAndComesBack) {
    MockController controller;
    controller.turns_for(std::chrono::milliseconds(300));
    const auto result = run_program(check_of(controller, {"--move", "--json"}));
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    const auto json = result.json();
    ASSERT_TRUE(json.is_object()) << result.out;
    EXPECT_EQ(json["format"], "gripscan-robot-check/1");
    EXPECT_EQ(json["conforms"], true);
    for (const auto& check : json["checks"]) {
        EXPECT_THAT(check["outcome"], testing::AnyOf("passed", "noted")) << check;
    }
    EXPECT_GT(controller.arm().moves(), 0);
    EXPECT_NEAR(controller.arm().joints_deg()[5], 0.0, 1e-9);
}

TEST(RobotCheck, AControllerThatDoesNotConformIsStatusOne) {
    MockController controller;
    controller.hears(Side::kMotion, with("HELLO 99", "HELLO 1"));
    const auto result = run_program(check_of(controller));
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, HasSubstr("failed   hello.version"));
    EXPECT_THAT(result.out, HasSubstr("required: ERR 0 102 to HELLO 99"));
    EXPECT_THAT(result.err, HasSubstr("does not conform"));
    const auto json = run_program(check_of(controller, {"--json"}));
    EXPECT_EQ(json.status, 1);
    EXPECT_EQ(json.json()["conforms"], false);
}

TEST(RobotCheck, NobodyThereIsStatusThree) {
    std::uint16_t port = 0;
    { port = TcpListener::open(0).value().port(); }
    const auto result = run_program({"robot-check", "localhost:" + std::to_string(port)});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr("localhost:" + std::to_string(port)));
}

TEST(RobotCheck, AnAddressThatIsNoneIsStatusTwo) {
    for (const std::string address : {"[::1", "[::1]x", "[::1]:x", "[]"}) {
        const auto result = run_program({"robot-check", address});
        EXPECT_EQ(result.status, 2) << address << result.err;
    }
    std::uint16_t port = 0;
    { port = TcpListener::open(0).value().port(); }
    const auto result = run_program({"robot-check", "[::1]:" + std::to_string(port)});
    EXPECT_EQ(result.status, 3);
    EXPECT_THAT(result.err, HasSubstr("[::1]:" + std::to_string(port)));
}

TEST(RobotCheck, APortThatAnotherClientHoldsIsStatusThreeWithOneMessage) {
    MockController controller;
    const auto holder = TcpConnection::connect("127.0.0.1", controller.motion_port(),
                                               deadline_in(std::chrono::seconds(5)));
    ASSERT_TRUE(holder);
    const auto result = run_program(check_of(controller));
    EXPECT_EQ(result.status, 3) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr(std::to_string(controller.motion_port()) + " (motion)"));
    EXPECT_THAT(result.err, HasSubstr("end the other client"));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

}  // namespace
}  // namespace gripscan::test
