// A cell that is named by a file: what is wrong with it is said before anything is made.
#include <gmock/gmock.h>

#include "core/concurrency/tcp_listener.h"
#include "core/session/cell_file.h"
#include "core/stereo/rig_file.h"
#include "tests/integration/program.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(RealCell, ARegionThatCannotBeMatchedLeavesNoSessionBehind) {
    const TemporaryFolder folder;
    const fs::path file = folder / "cell/cell.yaml";
    const auto served = interrupt_program(
        {"simcell", "--port", "0", "--cell-out", (folder / "cell").string()}, [&] {
            if (!fs::exists(file)) return false;
            CellFile cell = load_cell_file(file).value();
            cell.region = Box{{-0.1, -0.1, 1e-6}, {0.1, 0.1, 1e6}};
            EXPECT_TRUE(save_cell_file(folder / "near.yaml", cell));
            const auto run =
                run_program({"run", "gripper", "--cell", (folder / "near.yaml").string(), "--out",
                             (folder / "s").string()});
            EXPECT_EQ(run.status, 2) << run.err;
            EXPECT_THAT(run.err, HasSubstr((folder / "near.yaml").string() + ": the region"));
            EXPECT_FALSE(fs::exists(folder / "s"));
            return true;
        });
    EXPECT_EQ(served.status, 0) << served.err;
}

TEST(RealCell, WaitingForItsCameraCanBeCancelled) {
    const TemporaryFolder folder;
    auto camera = TcpListener::open(0).value();  // takes a client, and never greets
    StereoRig rig;
    rig.image = {160, 120};
    rig.K_left << 150, 0, 79.5, 0, 150, 59.5, 0, 0, 1;
    rig.K_right = rig.K_left;
    rig.T_right_left.translation().x() = -0.1;
    ASSERT_TRUE(save_rig(folder / "rig.yaml", rig));
    CellFile cell;
    cell.robot = CellRobot{.dialect = "gsp1", .host = "127.0.0.1"};
    cell.camera = FrameServer{"127.0.0.1", camera.port()};
    cell.rig = folder / "rig.yaml";
    ASSERT_TRUE(save_cell_file(folder / "cell.yaml", cell));
    std::optional<TcpConnection> client;
    const auto begin = std::chrono::steady_clock::now();
    const auto run = interrupt_program({"run", "gripper", "--cell", (folder / "cell.yaml").string(),
                                        "--out", (folder / "s").string()},
                                       [&] {
                                           auto accepted = camera.accept(
                                               {}, deadline_in(std::chrono::milliseconds(100)));
                                           if (!accepted) return false;
                                           client.emplace(std::move(*accepted));
                                           return true;
                                       });
    EXPECT_EQ(run.status, 4) << run.err;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
    EXPECT_FALSE(fs::exists(folder / "s"));
}

}  // namespace
}  // namespace gripscan::test
