#include "core/session/cell_file.h"

#include <gmock/gmock.h>

#include "core/session/alignment_file.h"
#include "tests/support/random_pose.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kWhole =
    "format: gripscan-cell/1\n"
    "robot: {dialect: gsp1, host: 192.168.0.10, port: 18740, monitor_port: 18741,\n"
    "        speed_percent: 20, settle_ms: 500}\n"
    "camera: {driver: frames, host: cell.local, port: 18800}\n"
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
    EXPECT_EQ(cell->robot->settle_s, 0.5);
    EXPECT_EQ(*cell->camera, (FrameServer{"cell.local", 18800}));
    EXPECT_EQ(cell->rig, folder / "rig.yaml") << "relative to the cell file";
    EXPECT_EQ(cell->T_robot_camera->translation().x(), 0.5);
    EXPECT_EQ(cell->limits.slip_mm, 0.5);
    EXPECT_EQ(cell->template_library, folder / "templates");
}

TEST(CellFile, WhatIsAbsentHasTheDocumentedValues) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "cell.yaml",
                     "format: gripscan-cell/1\nrobot: {dialect: gsp1, host: r}\n"
                     "camera: {driver: frames, host: c}\n");
    const auto cell = load_cell_file(folder / "cell.yaml");
    ASSERT_TRUE(cell) << cell.error().message;
    EXPECT_EQ(*cell->robot, (CellRobot{"gsp1", "r", 18740, 18741, 10.0, 0.3}));
    EXPECT_EQ(*cell->camera, (FrameServer{"c", 18742}));
    EXPECT_TRUE(cell->rig.empty());
    EXPECT_EQ(cell->limits.slip_mm, LimitsDeg{}.slip_mm);

    test::write_text(folder / "port.yaml",
                     "format: gripscan-cell/1\nrobot: {dialect: gsp1, host: r, port: 9000}\n");
    EXPECT_EQ(load_cell_file(folder / "port.yaml")->robot->monitor_port, 9001);
    test::write_text(folder / "none.yaml", "format: gripscan-cell/1\n");
    EXPECT_FALSE(load_cell_file(folder / "none.yaml")->robot);
}

TEST(CellFile, ComesBackAsItWasSaved) {
    const test::TemporaryFolder folder;
    SeededRandom random(11);
    for (int i = 0; i < 20; ++i) {
        CellFile cell;
        cell.robot = CellRobot{"gsp1",         "host \"a\"\\b\n: #" + std::to_string(i),
                               1024 + 3 * i,   2048 + i,
                               5.0 + i * 0.37, i * 0.1};
        cell.camera = FrameServer{"::1", 4096 + i};
        cell.rig = i % 2 == 0 ? folder / "rigs/rig ü.yaml" : fs::path("/elsewhere/rig.yaml");
        cell.region = Box{{-random.uniform(), -0.1, 0.5}, {random.uniform(), 0.1, 0.9}};
        cell.axis_hint = test::random_direction(random);
        cell.T_robot_camera = test::random_pose(random, 2.0);
        cell.limits.slip_mm = random.uniform(0.1, 3.0);
        cell.template_library = folder / "templates";
        const Status saved = save_cell_file(folder / "cell.yaml", cell);
        ASSERT_TRUE(saved) << saved.error().message;
        const auto read = load_cell_file(folder / "cell.yaml");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->robot->host, cell.robot->host);
        EXPECT_EQ(read->robot->port, cell.robot->port);
        EXPECT_EQ(read->robot->monitor_port, cell.robot->monitor_port);
        EXPECT_EQ(read->robot->speed_percent, cell.robot->speed_percent);
        EXPECT_DOUBLE_EQ(read->robot->settle_s, cell.robot->settle_s);
        EXPECT_EQ(*read->camera, *cell.camera);
        EXPECT_EQ(read->rig, cell.rig);
        EXPECT_EQ(read->template_library, cell.template_library);
        EXPECT_EQ(read->region->min_m, cell.region->min_m);
        EXPECT_EQ(read->region->max_m, cell.region->max_m);
        // Both are made exact again by reading: a few units in the last place.
        EXPECT_TRUE(read->axis_hint->isApprox(*cell.axis_hint, 1e-14));
        EXPECT_TRUE(read->T_robot_camera->isApprox(*cell.T_robot_camera, 1e-14));
        EXPECT_EQ(read->limits.slip_mm, cell.limits.slip_mm);
    }
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
    EXPECT_THAT(problem("driver: frames", "drivers: frames"), HasSubstr("camera.driver"));
    EXPECT_THAT(problem("driver: frames", "driver: genicam"),
                HasSubstr("cell.yaml:4: camera.driver is 'genicam'; this version knows: frames"));
    EXPECT_THAT(problem("port: 18800", "exposure_us: 8000"),
                HasSubstr("cell.yaml:4: unknown key 'camera.exposure_us'"));
    EXPECT_THAT(problem("host: cell.local, ", ""), HasSubstr("camera.host is missing"));
    EXPECT_THAT(problem("monitor_port: 18741", "monitor_port: 18740"), HasSubstr("another port"));
    EXPECT_THAT(problem("settle_ms: 500", "settle_ms: -1"), HasSubstr("settle_ms"));
    EXPECT_THAT(problem("gripscan-cell/1", "gripscan-cell/9"), HasSubstr("gripscan-cell/9"));
}

TEST(CellFile, TakesTheAlignmentFromItsFile) {
    const test::TemporaryFolder folder;
    AlignmentFile alignment;
    alignment.T_robot_camera = Pose(Eigen::Translation3d(0.5, 0.0, 0.25));
    ASSERT_TRUE(save_alignment(folder / "alignment.yaml", alignment));
    test::write_text(folder / "cell.yaml", "format: gripscan-cell/1\nalignment: alignment.yaml\n");
    const auto cell = load_cell_file(folder / "cell.yaml");
    ASSERT_TRUE(cell) << cell.error().message;
    ASSERT_TRUE(cell->T_robot_camera);
    EXPECT_EQ(cell->T_robot_camera->translation().x(), 0.5);
    test::write_text(folder / "cell.yaml", "format: gripscan-cell/1\nalignment: nothing.yaml\n");
    const auto absent = load_cell_file(folder / "cell.yaml");
    ASSERT_FALSE(absent);
    EXPECT_THAT(absent.error().message, testing::HasSubstr("cell.yaml:2"));
    EXPECT_THAT(absent.error().message, testing::HasSubstr("nothing.yaml"));
}

TEST(CellFile, ACellFileIsNoAlignment) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "cell.yaml", "format: gripscan-cell/1\nalignment: cell.yaml\n");
    test::write_text(folder / "other.yaml", "format: gripscan-cell/1\nalignment: cell.yaml\n");
    for (const auto* name : {"cell.yaml", "other.yaml"}) {
        const auto cell = load_cell_file(folder / name);
        ASSERT_FALSE(cell);
        EXPECT_THAT(cell.error().message, HasSubstr(std::string(name) + ":2: alignment"));
        EXPECT_THAT(cell.error().message, HasSubstr("is a cell file"));
        EXPECT_FALSE(load_robot_camera(folder / name));
    }
}

TEST(CellFile, AnAxisHintOfAnyLengthIsADirectionOrRefused) {
    const test::TemporaryFolder folder;
    const auto hint = [&](const std::string& numbers) {
        test::write_text(folder / "cell.yaml",
                         "format: gripscan-cell/1\naxis_hint: " + numbers + "\n");
        return load_cell_file(folder / "cell.yaml");
    };
    EXPECT_NEAR(hint("[3e5, 4e5, 0]")->axis_hint->norm(), 1.0, 1e-12);
    for (const auto* numbers : {"[0, 0, 0]", "[1e200, 1e200, 0]", "[1e-200, 0, 0]"}) {
        const auto refused = hint(numbers);
        ASSERT_FALSE(refused) << numbers;
        EXPECT_THAT(refused.error().message, HasSubstr("axis_hint must be a direction"));
    }
}

}  // namespace
}  // namespace gripscan
