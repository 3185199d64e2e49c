// Has the environment moved? In a room with texture, and in the simulated cell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "core/base/units.h"
#include "core/scene/environment_learner.h"
#include "core/scene/scene_survey.h"
#include "core/sim/seeds.h"
#include "core/sim/sim_cell.h"
#include "core/sim/step_faults.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan {
namespace {

/// The simulated cell without its arm, at half the resolution.
class EmptyCell {
  public:
    EmptyCell(std::uint64_t seed, const std::vector<std::string>& faults = {}) {
        SimCellSettings settings;
        settings.seed = seed;
        settings.with_arm = false;
        settings.image_fraction = 2;
        settings.faults = faults;
        cell_ = std::make_unique<SimCell>(std::move(SimCell::create(settings).value()));
        rectifier_ =
            std::make_unique<Rectifier>(std::move(Rectifier::create(cell_->rig()).value()));
    }
    [[nodiscard]] Cloud look(int capture) {
        const auto frame = cell_->source().grab({capture, 1, 0});
        const auto rectified = rectifier_->rectify(frame.value());
        return stereo_cloud(rectified.value(), rectifier_->rig(), std::nullopt, {}, {},
                            for_each_in_order)
            .value()
            .cloud;
    }
    [[nodiscard]] const SimCell& cell() const { return *cell_; }

  private:
    std::unique_ptr<SimCell> cell_;
    std::unique_ptr<Rectifier> rectifier_;
};

EnvironmentModel learned(std::uint64_t seed) {
    EmptyCell cell(seed);
    EnvironmentLearner learner{LearnSettings{}};
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(learner.add(cell.look(i)));
    return learner.finish({}, for_each_in_order).value();
}

SceneSurvey surveyed(const EnvironmentModel& model, EmptyCell& now, int capture) {
    SceneKnowledge knowledge;
    knowledge.region = now.cell().region();
    const auto survey =
        survey_scene(model, now.look(capture), knowledge, {}, {}, for_each_in_order);
    EXPECT_TRUE(survey) << survey.error().message;
    return *survey;
}

/// Of `shift@0=2`, in the camera frame.
Eigen::Vector3d true_shift_m(std::uint64_t seed, const SimCell& cell) {
    const sim::StepFaults faults(sim::parse_faults({"shift@0=2"}).value(), cell.start_joint6_rad(),
                                 rad_from_deg(10.0), sim::seed_for(seed, sim::Use::kFaults));
    return cell.T_robot_camera().linear().transpose() *
           faults.surroundings_shift_m(cell.start_joint6_rad());
}

class WatchedCell : public testing::TestWithParam<std::uint64_t> {};

TEST_P(WatchedCell, EachIntruderOfTheSimulatedCellIsToldWhatAndWhere) {
    const std::uint64_t seed = GetParam();
    const EnvironmentModel model = learned(seed);

    EmptyCell same(seed);
    const SceneSurvey clear = surveyed(model, same, 100);
    EXPECT_TRUE(clear.clear()) << sentence(clear.shift);
    EXPECT_TRUE(clear.left_overs.empty());
    std::printf("seed %d still: %s\n", static_cast<int>(seed), sentence(clear.shift).c_str());

    // Half the camera's pixels make the disparities twice as uncertain in the room's 1.2 to 2 m:
    // 0.01 px of systematic error are 0.4 mm there.
    EmptyCell shifted(seed, {"shift@0=2"});
    const SceneSurvey moved = surveyed(model, shifted, 101);
    std::printf("seed %d shift: %s\n", static_cast<int>(seed), sentence(moved.shift).c_str());
    EXPECT_TRUE(moved.shift.moved);
    EXPECT_LT((moved.shift.shift_m - true_shift_m(seed, shifted.cell())).norm(), 0.0005)
        << true_shift_m(seed, shifted.cell()).transpose();
    EXPECT_LT(deg_from_rad(moved.shift.turn_rad), 0.05);
    EXPECT_TRUE(moved.left_overs.empty());

    EmptyCell with_tool(seed, {"tool@0"});
    const SceneSurvey tool = surveyed(model, with_tool, 102);
    EXPECT_FALSE(tool.shift.moved) << sentence(tool.shift);
    ASSERT_FALSE(tool.left_overs.empty());
    std::printf("seed %d tool: %s\n", static_cast<int>(seed), sentence(tool.left_overs[0]).c_str());
    EXPECT_GT(tool.left_overs[0].size_m.x(), 0.100);
    EXPECT_LT(tool.left_overs[0].size_m.x(), 0.160);
    EXPECT_LT(tool.left_overs[0].size_m.y(), 0.035);

    EmptyCell with_hand(seed, {"intruder@0=60"});
    const SceneSurvey hand = surveyed(model, with_hand, 103);
    ASSERT_EQ(hand.left_overs.size(), 1U);
    std::printf("seed %d hand: %s\n", static_cast<int>(seed), sentence(hand.left_overs[0]).c_str());
    EXPECT_NEAR(hand.left_overs[0].size_m.x(), 0.115, 0.02);
    EXPECT_NEAR(hand.left_overs[0].size_m.y(), 0.055, 0.012);
    EXPECT_TRUE(with_hand.cell().region().contains(hand.left_overs[0].centre_m));
}

INSTANTIATE_TEST_SUITE_P(Seeds, WatchedCell, testing::Values(1U, 2U));

}  // namespace
}  // namespace gripscan
