#include "core/session/cell_file.h"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

constexpr const char* kWhole =
    "format: gripscan-cell/1\n"
    "robot: {dialect: gsp1, host: 192.168.0.10, port: 18740, monitor_port: 18741,\n"
    "        speed_percent: 20, settle_ms: 500}\n"
    "camera: {driver: genicam, left: cam-1, right: cam-2, exposure_us: 8000}\n"
    "rig: rig.yaml\n"
    "region: {min: [-0.1, -0.1, 0.6], max: [0.1, 0.1, 0.8]}\n"
    "axis_hint: [1, 0, 0]\n"
    "alignment: [1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n"
    "limits: {slip_mm: 0.5}\n"
    "template_library: templates\n";

TEST(CellFile, ReadsEverythingOfTheContract) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "cell.yaml", kWhole);
    const auto cell = load_cell_file(folder / "cell.yaml");
    ASSERT_TRUE(cell) << cell.error().message;
    EXPECT_EQ(cell->robot->dialect, "gsp1");
    EXPECT_EQ(cell->robot->port, 18740);
    EXPECT_EQ(cell->robot->settle_ms, 500.0);
    EXPECT_EQ(cell->camera_driver, "genicam");
    EXPECT_EQ(cell->T_robot_camera->translation().x(), 0.5);
    EXPECT_EQ(cell->limits.slip_mm, 0.5);
    EXPECT_EQ(cell->template_library, "templates");
}

TEST(CellFile, SaysWhatIsWrongAndWhere) {
    const test::TemporaryFolder folder;
    const auto problem = [&](const std::string& from, const std::string& to) {
        test::write_text(folder / "cell.yaml", kWhole);
        test::replace_in_file(folder / "cell.yaml", from, to);
        const auto cell = load_cell_file(folder / "cell.yaml");
        return cell ? std::string("no problem") : cell.error().message;
    };
    EXPECT_THAT(problem("rig: rig.yaml", "rigg: rig.yaml"),
                HasSubstr("cell.yaml:5: unknown key 'rigg'"));
    EXPECT_THAT(problem("host: 192", "hosts: 192"), HasSubstr("unknown key 'robot.hosts'"));
    EXPECT_THAT(problem("port: 18740", "port: 1.5"), HasSubstr("cell.yaml:2: robot.port"));
    EXPECT_THAT(problem("speed_percent: 20", "speed_percent: 200"), HasSubstr("speed_percent"));
    EXPECT_THAT(problem("[1, 0, 0, 0.5", "[2, 0, 0, 0.5"), HasSubstr("no rigid motion"));
    EXPECT_THAT(problem("driver: genicam", "drivers: genicam"), HasSubstr("camera.driver"));
    EXPECT_THAT(problem("gripscan-cell/1", "gripscan-cell/9"), HasSubstr("gripscan-cell/9"));
}

}  // namespace
}  // namespace gripscan
