#include <gmock/gmock.h>

#include "tests/integration/program.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;

TEST(CommandLine, TellsItsVersionAndHelps) {
    const auto version = run_program({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_THAT(version.out, testing::StartsWith("gripscan "));
    const auto help = run_program({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_THAT(help.out, HasSubstr("Examples:"));
}

TEST(CommandLine, EverySubcommandHelpsWithAnExample) {
    for (const Arguments& command : {Arguments{"replay"},
                                     {"align"},
                                     {"stereo"},
                                     {"export"},
                                     {"report"},
                                     {"robot-check"},
                                     {"run", "gripper"},
                                     {"calibrate", "stereo"}}) {
        Arguments arguments = command;
        arguments.push_back("--help");
        const auto help = run_program(arguments);
        EXPECT_EQ(help.status, 0) << command[0];
        EXPECT_THAT(help.out, HasSubstr("Example")) << command[0];
        for (const char* option : {"--json", "--quiet", "--version"}) {
            EXPECT_THAT(help.out, HasSubstr(option)) << command[0];
        }
        arguments.back() = "--version";
        EXPECT_EQ(run_program(arguments).status, 0) << command[0];
    }
}

TEST(CommandLine, WrongUsageIsStatusTwoAndLeavesStandardOutputEmpty) {
    for (const Arguments& arguments : {Arguments{"dance"},
                                       {"replay"},
                                       {"run"},
                                       {"run", "gripper"},
                                       {"run", "dance"},
                                       {"align", "one.pcd"},
                                       {"replay", "s", "--method", "magic"},
                                       {"replay", "s", "--bogus"},
                                       {"stereo", "l.png", "r.png"},
                                       {"calibrate"},
                                       {"robot-check"},
                                       {"robot-check", "localhost:0"},
                                       {"robot-check", "localhost:70000"},
                                       {"robot-check", "localhost:65535"},
                                       {"robot-check", ":18740"},
                                       {"robot-check", "localhost", "--monitor-port", "0"},
                                       {"robot-check", "localhost", "--dialect", "magic"},
                                       {"calibrate", "stereo"},
                                       {"align", "a.pcd", "b.pcd", "--rotation-deg", "ten"},
                                       {"export", "s", "--out", "f.pcd", "--unit", "inch"},
                                       {"run", "gripper", "--out", "x", "--step-deg", "0"}}) {
        const auto result = run_program(arguments);
        EXPECT_EQ(result.status, 2) << testing::PrintToString(arguments);
        EXPECT_EQ(result.out, "") << testing::PrintToString(arguments);
        EXPECT_NE(result.err, "") << testing::PrintToString(arguments);
    }
}

/// Without a subcommand it is the window, which needs a screen.
TEST(CommandLine, WithoutASubcommandAndAScreenItNamesTheWayOn) {
    const auto result = run_program({}, {"DISPLAY="});
    EXPECT_EQ(result.status, 3);
    EXPECT_THAT(result.err, HasSubstr("gripscan --help"));
}

}  // namespace
}  // namespace gripscan::test
