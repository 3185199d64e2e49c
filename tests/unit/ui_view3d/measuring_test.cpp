#include "ui/views/measuring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/random_pose.h"
#include "ui/views/image_zoom.h"
#include "ui/views/navigation.h"
#include "ui/views/view_keys.h"

namespace gripscan::ui {
namespace {

TEST(Measuring, SaysDifferencesAndDistance) {
    Measuring measuring{true, {}};
    measuring = with_point(measuring, {0.001, 0.002, 0.703});
    EXPECT_EQ(measure_hint(measuring), "Click the second point");
    EXPECT_TRUE(measure_lines(measuring, std::nullopt).empty());
    measuring = with_point(measuring, {0.004, -0.002, 0.703});
    const auto lines = measure_lines(measuring, std::nullopt);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0].value, "5.00");
    EXPECT_EQ(lines[1].value, "3.00");
    EXPECT_EQ(lines[2].value, "−4.00");
    EXPECT_EQ(lines[3].value, "0.00");
    EXPECT_EQ(with_point(measuring, {1, 1, 1}).points_m.size(), 1U) << "a third begins anew";
}

TEST(Measuring, AboutAnAxisFollowsATurnOfThePoint) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        SeededRandom random(seed);
        const Pose T = test::random_pose(random, 3.0);
        const Axis axis{T.translation(), T.linear().col(2)};
        const Eigen::Vector3d p = T * Eigen::Vector3d(0.05, 0.02, 0.03);
        const AboutAxis before = about_axis(p, axis);
        EXPECT_NEAR(before.radius_m, std::hypot(0.05, 0.02), 1e-12);
        EXPECT_NEAR(before.height_m, 0.03, 1e-12);
        const double turn = random.uniform(-3.0, 3.0);
        const AboutAxis after = about_axis(turn_about(axis, turn) * p, axis);
        EXPECT_NEAR(after.radius_m, before.radius_m, 1e-12);
        EXPECT_NEAR(after.height_m, before.height_m, 1e-12);
        EXPECT_NEAR(
            std::remainder(after.angle_rad - before.angle_rad - turn, 2.0 * std::numbers::pi), 0.0,
            1e-9);
    }
}

TEST(Measuring, WithAnAxisTellsRadiusAngleAndHeightOfBothPoints) {
    const Axis axis{{0, 0, 0.7}, Eigen::Vector3d::UnitX()};
    // y points away from the axis at angle 0; a quarter turn about x leads to z.
    const Measuring measuring{true, {{0.01, 0.03, 0.7}, {-0.02, 0.0, 0.74}}};
    const auto lines = measure_lines(measuring, axis);
    ASSERT_EQ(lines.size(), 11U);
    EXPECT_EQ(lines[4].value, "30.00");
    EXPECT_EQ(lines[5].value, "0.00");
    EXPECT_EQ(lines[6].value, "10.00");
    EXPECT_EQ(lines[7].value, "40.00");
    EXPECT_EQ(lines[8].value, "90.00");
    EXPECT_EQ(lines[9].value, "−20.00");
    EXPECT_EQ(lines[10].value, "90.00");
}

TEST(Navigation, FollowsThePreset) {
    using enum ViewMotion;
    struct Row {
        const char* preset;
        ViewMotion left, right, middle, shift_left;
    };
    for (const Row& row :
         {Row{"gripscan", kOrbit, kPan, kPan, kPan}, Row{"CAD", kNone, kPan, kOrbit, kNone},
          Row{"RViz", kOrbit, kZoom, kPan, kPan}, Row{"unknown", kOrbit, kPan, kPan, kPan}}) {
        EXPECT_EQ(motion_of(row.preset, MouseButton::kLeft, false), row.left) << row.preset;
        EXPECT_EQ(motion_of(row.preset, MouseButton::kRight, false), row.right) << row.preset;
        EXPECT_EQ(motion_of(row.preset, MouseButton::kMiddle, false), row.middle) << row.preset;
        EXPECT_EQ(motion_of(row.preset, MouseButton::kLeft, true), row.shift_left) << row.preset;
    }
    EXPECT_EQ(motion_of("CAD", MouseButton::kMiddle, true), kPan);
}

TEST(ViewKeys, CanBeRemapped) {
    WindowPreferences preferences;
    EXPECT_EQ(view_command("F", preferences), ViewCommand::kFitSelection);
    EXPECT_EQ(view_command("Ctrl+3", preferences), ViewCommand::kSide);
    EXPECT_EQ(view_command("Q", preferences), std::nullopt);
    preferences.keys = {{"view.fit", "Q"}};
    EXPECT_EQ(view_command("Q", preferences), ViewCommand::kFitSelection);
    EXPECT_EQ(view_command("F", preferences), std::nullopt);
}

TEST(ImageZoom, KeepsThePixelUnderTheCursor) {
    const ImageFrame frame{{312.0, 200.0}, {640.0, 480.0}};
    ImageZoom zoom = zoomed_at({}, 6.0, {150.0, 90.0}, frame);
    for (const double clicks : {1.0, -2.0, 4.0}) {
        const Eigen::Vector2d before = frame.to_image(zoom, {150.0, 110.0});
        zoom = zoomed_at(zoom, clicks, {150.0, 110.0}, frame);
        const Eigen::Vector2d after = frame.to_image(zoom, {150.0, 110.0});
        EXPECT_NEAR((after - before).norm(), 0.0, 1e-9);
        EXPECT_NEAR((frame.to_frame(zoom, after) - Eigen::Vector2d(150.0, 110.0)).norm(), 0.0,
                    1e-9);
    }
}

TEST(ImageZoom, NeverShowsABorderWhileTheImageIsLarger) {
    const ImageFrame frame{{300.0, 200.0}, {640.0, 480.0}};
    ImageZoom zoom = zoomed_at({}, 8.0, {10.0, 10.0}, frame);
    zoom = moved_by(zoom, {1e5, -1e5}, frame);
    EXPECT_NEAR(frame.to_image(zoom, {0.0, 0.0}).x(), 0.0, 1e-9);
    EXPECT_NEAR(frame.to_image(zoom, {0.0, 200.0}).y(), 480.0, 1e-9);
    EXPECT_EQ(zoomed_at(zoom, -100.0, {3.0, 3.0}, frame), ImageZoom{}) << "the whole is centred";
}

}  // namespace
}  // namespace gripscan::ui
