#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "core/camera/frame_client.h"
#include "core/concurrency/tcp_listener.h"
#include "core/robot/gsp_link.h"
#include "core/session/cell_file.h"
#include "core/stereo/rig_file.h"
#include "tests/integration/program.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::test {
namespace {

std::uint16_t port_in(const std::string& text, const std::string& name) {
    std::smatch match;
    const std::regex pattern(name + ": ?([0-9]+)");
    return std::regex_search(text, match, pattern)
               ? static_cast<std::uint16_t>(std::stoul(match[1]))
               : std::uint16_t{0};
}

/// Talks to the robot and the camera of a cell as its files say.
void use(const std::string& cell_yaml) {
    gsp::GspSettings robot_at;
    robot_at.motion_port = port_in(cell_yaml, "port");
    robot_at.monitor_port = port_in(cell_yaml, "monitor_port");
    gsp::GspLink robot(robot_at);
    const auto connected = robot.connect();
    ASSERT_TRUE(connected) << connected.error().message;
    const auto there = robot.turn_joint6({1, -3.0, 20.0}, {});
    ASSERT_TRUE(there) << there.error().message;
    FrameClientSettings camera_at;
    camera_at.port = port_in(cell_yaml.substr(cell_yaml.find("driver: frames")), "port");
    const auto camera = FrameClient::connect(camera_at);
    ASSERT_TRUE(camera) << camera.error().message;
    const auto frame = (*camera)->grab({0, 1});
    ASSERT_TRUE(frame) << frame.error().message;
    EXPECT_EQ(frame->left.cols, 1280);
}

TEST(Simcell, ServesWhatItsFilesSayUntilItIsStopped) {
    const TemporaryFolder folder;
    const auto cell_path = folder / "cell" / "cell.yaml";
    const ProgramResult result = interrupt_program(
        {"simcell", "--port", "0", "--seed", "4", "--time-scale", "50", "--cell-out",
         (folder / "cell").string(), "--truth", (folder / "truth").string()},
        [&] {
            if (!std::filesystem::exists(cell_path)) return false;
            use(read_text(cell_path));
            return true;
        });
    EXPECT_EQ(result.status, 0) << result.err;
    std::smatch said;
    ASSERT_TRUE(std::regex_match(
        result.out, said, std::regex("listening motion=(\\d+) monitor=(\\d+) frames=(\\d+)\n")))
        << result.out;
    EXPECT_EQ(said[1], std::to_string(port_in(read_text(cell_path), "port")));
    EXPECT_TRUE(load_cell_file(cell_path));
    EXPECT_TRUE(load_rig(folder / "cell" / "rig.yaml"));
    EXPECT_TRUE(std::filesystem::exists(folder / "truth" / "truth.json"));
}

TEST(Simcell, WithoutAPictureThereIsNoTruthToWrite) {
    const TemporaryFolder folder;
    const auto truth = folder / "truth";
    const ProgramResult result =
        interrupt_program({"simcell", "--port", "0", "--cell-out", (folder / "cell").string(),
                           "--truth", truth.string()},
                          [&] { return std::filesystem::exists(folder / "cell" / "cell.yaml"); });
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_THAT(result.err, ::testing::HasSubstr("no picture was taken"));
    EXPECT_FALSE(std::filesystem::exists(truth));
}

TEST(Simcell, ConformsAsTheProgramsOwnCheckSeesIt) {
    const TemporaryFolder folder;
    const auto cell_path = folder / "cell" / "cell.yaml";
    ProgramResult check;
    const ProgramResult served = interrupt_program(
        {"simcell", "--port", "0", "--time-scale", "5", "--json", "--cell-out",
         (folder / "cell").string()},
        [&] {
            if (!std::filesystem::exists(cell_path)) return false;
            const std::string yaml = read_text(cell_path);
            check = run_program({"robot-check",
                                 "127.0.0.1:" + std::to_string(port_in(yaml, "port")), "--move",
                                 "--monitor-port", std::to_string(port_in(yaml, "monitor_port"))});
            return true;
        });
    EXPECT_EQ(served.status, 0) << served.err;
    EXPECT_EQ(check.status, 0) << check.out << check.err;
    EXPECT_THAT(check.out, ::testing::HasSubstr("passed   move.return"));
    // One line, so that who starts it can read it while it serves.
    ASSERT_EQ(std::count(served.out.begin(), served.out.end(), '\n'), 1) << served.out;
    const auto json = served.json();
    ASSERT_TRUE(json.is_object()) << served.out;
    EXPECT_EQ(json["format"], "gripscan-simcell/1");
    const std::string yaml = read_text(cell_path);
    EXPECT_EQ(json["motion_port"], port_in(yaml, "port"));
    EXPECT_EQ(json["monitor_port"], port_in(yaml, "monitor_port"));
    EXPECT_EQ(json["frames_port"], port_in(yaml.substr(yaml.find("driver: frames")), "port"));
}

TEST(Simcell, SaysWhyItDoesNotStart) {
    const ProgramResult unknown = run_program({"simcell", "--port", "0", "--fault", "gremlin"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, ::testing::HasSubstr("'gremlin'; there are delay, drop"));
    const auto taken = TcpListener::open(0);
    ASSERT_TRUE(taken);
    const std::string port = std::to_string(taken->port());
    const ProgramResult refused = run_program({"simcell", "--port", port});
    EXPECT_EQ(refused.status, 3);
    EXPECT_THAT(refused.err, ::testing::HasSubstr(port));
    EXPECT_EQ(refused.out, "");
}

}  // namespace
}  // namespace gripscan::test
