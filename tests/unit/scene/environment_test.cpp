// The static environment learned from noisy captures, and taken away from later ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "core/scene/environment_file.h"
#include "core/scene/environment_learner.h"
#include "synthetic_room.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

using test::SyntheticRoom;

EnvironmentModel learned(const SyntheticRoom& room, int captures, std::uint64_t seed,
                         const LearnSettings& settings = {}) {
    EnvironmentLearner learner(settings);
    for (int i = 0; i < captures; ++i) {
        const Status added = learner.add(room.capture(1000 * seed + static_cast<std::uint64_t>(i)));
        EXPECT_TRUE(added) << added.error().message;
    }
    auto model = learner.finish({}, for_each_in_order);
    EXPECT_TRUE(model) << model.error().message;
    return std::move(*model);
}

bool in_square(int u, int v) {
    return u >= 40 && u < 60 && v >= 60 && v < 80;
}

TEST(Environment, KnowsTheCameraAndItsNoise) {
    const SyntheticRoom room;
    const EnvironmentModel model = learned(room, 8, 1);
    EXPECT_NEAR(model.camera.fu_px, room.f_px, 0.01);
    EXPECT_NEAR(model.camera.cv_px, 90.0, 0.01);
    // A median over some ten thousand pixels: 3 % covers its scatter and the pixels at edges.
    EXPECT_NEAR(model.noise_per_m, room.noise_per_m(), 0.03 * room.noise_per_m());
    EXPECT_GT(model.known(), 0.99);
}

TEST(Environment, LeavesNoGhostsAtEdgesGapsAndSlopes) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const SyntheticRoom room;
        const EnvironmentModel model = learned(room, 8, seed);
        const Cloud scene = room.capture(77 + seed);
        const auto other = model.subtract(scene);
        ASSERT_TRUE(other);
        // 4 sigma leave 6e-5 of normal noise; deviations estimated from eight views have heavier
        // tails, and neighbours add to the range. A handful of 42 000.
        EXPECT_LE(other->size(), 10U) << "seed " << seed;
    }
}

TEST(Environment, KeepsWhatHasCome) {
    SyntheticRoom room;
    const EnvironmentModel model = learned(room, 8, 2);
    // 45 mm before the wall at 1.8 m are 0.43 px, 8.5 times the noise: 4 for the limit, 1 for the
    // largest mean of 25 neighbours, and 3 for the point's own noise.
    room.thing = [](int u, int v) { return in_square(u, v) ? 1.8 - 0.045 : 0.0; };
    const Cloud scene = room.capture(5);
    const auto other = model.subtract(scene);
    ASSERT_TRUE(other);
    std::size_t there = 0;
    for (const auto cell : scene.cell) there += in_square(cell % room.width, cell / room.width);
    std::size_t found = 0;
    for (const auto i : *other) {
        found += in_square(scene.cell[i] % room.width, scene.cell[i] / room.width);
    }
    EXPECT_GT(static_cast<double>(found), 0.99 * static_cast<double>(there));
    EXPECT_LE(other->size() - found, 10U);
}

TEST(Environment, TellsWhatHasGoneFromWhatHasCome) {
    SyntheticRoom room;
    room.thing = [](int u, int v) { return in_square(u, v) ? 1.2 : 0.0; };
    const EnvironmentModel model = learned(room, 8, 3);
    room.thing = nullptr;
    const Cloud scene = room.capture(6);
    const auto kinds = model.classify(scene, {}, for_each_in_order);
    std::size_t behind = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const bool inside = in_square(scene.cell[i] % room.width, scene.cell[i] / room.width);
        if (kinds[i] == ScenePoint::kBehind) ++behind;
        EXPECT_TRUE(inside || kinds[i] != ScenePoint::kInFront);
    }
    // All of the square but its rim of two pixels, and 4 % that are not matched.
    EXPECT_GT(behind, 230U);
    const auto other = model.subtract(scene);
    ASSERT_TRUE(other);
    EXPECT_LE(other->size(), 10U);
}

TEST(Environment, IsLearnedBehindAnArmThatStandsElsewhereEveryTime) {
    SyntheticRoom room;
    LearnSettings settings;
    settings.arm_in_view = true;
    EnvironmentLearner learner(settings);
    for (int i = 0; i < 8; ++i) {
        room.thing = [i](int u, int v) {
            return u >= 20 * i && u < 20 * i + 45 && v >= 40 && v < 80 ? 0.9 : 0.0;
        };
        ASSERT_TRUE(learner.add(room.capture(40 + static_cast<std::uint64_t>(i))));
    }
    const auto model = learner.finish({}, for_each_in_order);
    ASSERT_TRUE(model) << model.error().message;
    room.thing = nullptr;
    const auto empty = model->subtract(room.capture(9));
    ASSERT_TRUE(empty);
    // The posts' edges flicker and only the farther side counts there, so a few more remain.
    EXPECT_LE(empty->size(), 300U);
    // Where the arm was, its zone is known; where it never was, it is not.
    EXPECT_TRUE(model->arm.near(model->camera.point_m(60, 60, 0.9)));
    EXPECT_FALSE(model->arm.near(model->camera.point_m(60, 110, 0.9)));
    room.thing = [](int u, int v) { return in_square(u, v) ? 0.9 : 0.0; };
    const auto with_arm = model->subtract(room.capture(10));
    ASSERT_TRUE(with_arm);
    EXPECT_GE(with_arm->size(), 370U);
}

TEST(Environment, FileGivesBackTheSameModelAndRefusesADamagedOne) {
    const test::TemporaryFolder folder;
    SyntheticRoom room;
    LearnSettings settings;
    settings.arm_in_view = true;
    const EnvironmentModel model = learned(room, 4, 4, settings);
    const auto path = folder.path() / "environment.bin";
    ASSERT_TRUE(save_environment(path, model));
    const auto again = load_environment(path);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_TRUE(*again == model);

    std::string bytes = *read_whole_file(path);
    const auto refused = [&](const std::string& text) {
        EXPECT_TRUE(write_file_atomically(path, text));
        const auto loaded = load_environment(path);
        return loaded ? std::string("loaded") : loaded.error().message;
    };
    EXPECT_THAT(refused(bytes.substr(0, bytes.size() / 2)), testing::HasSubstr("damaged"));
    std::string flipped = bytes;
    flipped[bytes.size() / 3] = static_cast<char>(flipped[bytes.size() / 3] ^ 1);
    EXPECT_THAT(refused(flipped), testing::HasSubstr("damaged"));
    std::string newer = bytes;
    newer[21] = '2';
    EXPECT_THAT(refused(newer), testing::HasSubstr("another version"));
    EXPECT_THAT(refused("x"), testing::HasSubstr("no environment"));
    EXPECT_THAT(refused(bytes.substr(0, 25)), testing::HasSubstr("cut short"));
}

TEST(Environment, RefusesAnotherCamera) {
    SyntheticRoom room;
    const EnvironmentModel model = learned(room, 4, 5);
    SyntheticRoom other;
    other.f_px = 256.0;
    const auto refused = model.subtract(other.capture(1));
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, testing::HasSubstr("another calibration"));
    other.width = 200;
    const auto smaller = model.subtract(other.capture(1));
    ASSERT_FALSE(smaller);
    EXPECT_THAT(smaller.error().message, testing::HasSubstr("240 x 180"));
}

TEST(Environment, NeedsSeveralCapturesAndSomethingToSee) {
    const SyntheticRoom room;
    EnvironmentLearner learner{LearnSettings{}};
    ASSERT_TRUE(learner.add(room.capture(1)));
    ASSERT_TRUE(learner.add(room.capture(2)));
    const auto few = learner.finish({}, for_each_in_order);
    ASSERT_FALSE(few);
    EXPECT_THAT(few.error().message, testing::HasSubstr("at least 3"));
    EnvironmentLearner dark{LearnSettings{}};
    Cloud nothing;
    nothing.grid_width = 240;
    nothing.grid_height = 180;
    EXPECT_FALSE(dark.add(nothing));
}

}  // namespace
}  // namespace gripscan
