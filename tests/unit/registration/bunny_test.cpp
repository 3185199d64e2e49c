// Neighbouring range scans of a real object from perturbed starts: right, or not accepted. A false
// minimum must never be returned as a success.
#include <gtest/gtest.h>

#include <array>

#include "core/cloud/cloud_file.h"
#include "tests/support/random_pose.h"
#include "tests/support/test_data.h"
#include "tests/unit/registration/align_case.h"
#include "tests/unit/registration/bunny.h"

namespace gripscan {
namespace {

using namespace test;

/// Moves the cloud by up to 25 degrees about its middle and up to 20 mm, seeded.
Pose perturbation(const Cloud& cloud, std::uint64_t seed) {
    SeededRandom random(seed);
    Vector6d motion;
    motion << rad_from_deg(random.uniform(0.0, 25.0)) * random_direction(random),
        random.uniform(0.0, 0.02) * random_direction(random);
    return motion_about(motion, centroid(cloud));
}

struct Step {
    const char* from;
    const char* to;
    /// bun.conf is good to about 0.2 degrees and scanner scans differ by as much; where the two
    /// share little, ICP ends 2.35 degrees and 2.8 mm from it along the valley of its residuals.
    double deg = 0.6;
    double mm = 1.5;
};

void PrintTo(const Step& step, std::ostream* out) {
    *out << step.from << " -> " << step.to;
}

class BunnyScans : public testing::TestWithParam<Step> {};

TEST_P(BunnyScans, AreRightOrNotAccepted) {
    GRIPSCAN_TEST_DATA(folder, "bunny");
    const auto poses = bunny_poses(folder);
    const Step step = GetParam();
    const auto load = [&](const char* name) {
        auto cloud = load_cloud(folder / name);
        EXPECT_TRUE(cloud) << cloud.error().message;
        return thinned(*cloud, 1e-3);
    };
    const Cloud source = load(step.from);
    const Cloud target = load(step.to);
    const Pose truth = poses.at(step.to).inverse() * poses.at(step.from);
    int right = 0;
    constexpr int kSeeds = 4;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Pose moved = perturbation(source, seed);
        const Alignment a = aligned(transformed(source, moved), target);
        const PoseError error = pose_error(a.T_target_source * moved, truth, centroid(source));
        const bool good = error.deg < step.deg && error.mm < step.mm;
        right += good ? 1 : 0;
        std::cout << step.from << " -> " << step.to << " seed " << seed << ": " << error.deg
                  << " deg, " << error.mm << " mm, " << word(a.verdict) << ": " << a.sentence
                  << '\n';
        EXPECT_TRUE(good || a.verdict != Verdict::kAccept)
            << "a false minimum was accepted, " << error.deg << " deg and " << error.mm
            << " mm off: " << a.sentence;
    }
    std::cout << right << " of " << kSeeds << " starts right\n";
}

INSTANTIATE_TEST_SUITE_P(
    Neighbours, BunnyScans,
    testing::Values(Step{"bun000.ply", "bun045.ply"}, Step{"bun045.ply", "bun090.ply"},
                    Step{"bun090.ply", "bun180.ply", 2.5, 3.0}, Step{"bun180.ply", "bun270.ply"},
                    Step{"bun270.ply", "bun315.ply"}, Step{"bun315.ply", "bun000.ply"}));

}  // namespace
}  // namespace gripscan
