// A whole turn of 36 steps against the truth: angles, poses, axis, closure, template.
#include "core/registration/solve_turn.h"

#include <gtest/gtest.h>

#include "tests/unit/registration/solve_turn_case.h"

namespace gripscan {
namespace {

using namespace test;

double mean_error_deg(const TurnReport& report, double step_deg) {
    double sum = 0.0;
    for (const TurnStep& step : report.steps) {
        sum += std::abs(deg_from_rad(step.icp_rad.value_or(0.0)) - step_deg);
    }
    return sum / static_cast<double>(report.steps.size());
}

/// Three seconds of work, done once for all tests of the closing turn.
class ClosingTurn : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        turn_ = new TurnCase(make_turn({}));
        report_ = new TurnReport(solved(turn_->views));
    }
    static void TearDownTestSuite() {
        delete report_;
        delete turn_;
    }
    static TurnCase* turn_;
    static TurnReport* report_;
};
TurnCase* ClosingTurn::turn_ = nullptr;
TurnReport* ClosingTurn::report_ = nullptr;

TEST_F(ClosingTurn, EveryStepIsFoundAndAccepted) {
    ASSERT_EQ(report_->steps.size(), 36U);
    for (const TurnStep& step : report_->steps) {
        ASSERT_TRUE(step.icp_rad && step.sigma_rad);
        const double error_rad = *step.icp_rad - rad_from_deg(10.0);
        EXPECT_EQ(word(step.verdict), "accept") << step.index << ": " << step.sentence;
        EXPECT_TRUE(step.independent);
        // 36 steps: 4 sigma is once in 400 turns.
        EXPECT_LT(std::abs(error_rad), 4.0 * *step.sigma_rad)
            << step.index << ": " << deg_from_rad(error_rad) << " deg";
        EXPECT_LT(std::abs(deg_from_rad(error_rad)), 0.5) << step.index;
        EXPECT_LT(std::abs(*step.slip_m), 0.5e-3);
    }
    EXPECT_LT(mean_error_deg(*report_, 10.0), 0.15);
    EXPECT_TRUE(all_trusted(*report_));
    EXPECT_EQ(report_->sign_source, SignSource::kJoint);
}

TEST_F(ClosingTurn, JointPosesAreNearerTheTruthThanTheChain) {
    ASSERT_EQ(report_->poses.size(), turn_->views.size());
    const Eigen::Vector3d middle = centroid(turn_->views[0].cloud);
    Pose chain = Pose::Identity();
    double worst_chain = 0.0;
    double worst_joint = 0.0;
    for (std::size_t k = 0; k < report_->poses.size(); ++k) {
        if (k > 0) chain = *report_->steps[k - 1].T * chain;
        worst_chain = std::max(worst_chain, pose_error(chain, turn_->T_view_first[k], middle).deg);
        ASSERT_TRUE(report_->poses[k]) << k;
        const PoseError error =
            pose_error(report_->poses[k]->inverse(), turn_->T_view_first[k], middle);
        worst_joint = std::max(worst_joint, error.deg);
        // The robot's 0.01 degrees, the arm's wobble of 2e-4 rad and its 0.03 mm, four times.
        EXPECT_LT(error.deg, 0.1) << k;
        EXPECT_LT(error.mm, 0.3) << k;
    }
    EXPECT_LT(worst_joint, worst_chain);
}

TEST_F(ClosingTurn, AxisAndClosure) {
    ASSERT_TRUE(report_->axis);
    EXPECT_GT(report_->axis->axis.direction.dot(turn_->axis.direction),
              std::cos(rad_from_deg(0.15)));
    EXPECT_LT(turn_->axis.distance_m(report_->axis->axis.point_m), 0.2e-3);
    ASSERT_TRUE(report_->closure_before && report_->closure_after);
    // 36 steps of independent errors of about 0.05 degrees in each direction.
    EXPECT_LT(deg_from_rad(report_->closure_before->angle_rad), 2.0);
    EXPECT_LT(deg_from_rad(report_->closure_after->angle_rad), 0.1);
    EXPECT_LT(report_->closure_after->angle_rad, report_->closure_before->angle_rad);
    EXPECT_LT(report_->closure_after->shift_m, 0.2e-3);
    EXPECT_FALSE(report_->angle_scale);
}

TEST_F(ClosingTurn, TemplateLiesOnThePart) {
    EXPECT_GT(report_->merged.size(), 8000U);
    // Edges are rounded by the averaging; flat parts are known to a fraction of the 0.2 mm.
    EXPECT_GT(share_on_surface(report_->merged, *turn_, 0.5e-3), 0.90);
    EXPECT_GT(share_on_surface(report_->merged, *turn_, 1.0e-3), 0.97);
}

/// Independence: the scans' own angles do not change at all when every angle of the robot is
/// replaced or removed.
TEST_F(ClosingTurn, RobotAnglesDoNotEnterTheEstimates) {
    std::vector<TurnView> some(turn_->views.begin(), turn_->views.begin() + 5);
    const TurnReport known = solved(some);
    auto replaced = some;
    for (TurnView& view : replaced) {
        view.joint6_rad = *view.joint6_rad * 1.3;
        view.commanded_rad = *view.commanded_rad * 1.3;
    }
    auto removed = some;
    for (TurnView& view : removed) {
        view.joint6_rad.reset();
        view.commanded_rad.reset();
    }
    TurnSettings other_step;
    other_step.step_rad = 0.5;
    for (const auto& [views, settings] :
         {std::pair{replaced, TurnSettings{}}, std::pair{removed, TurnSettings{}},
          std::pair{some, other_step}}) {
        const TurnReport report = solved(views, settings);
        ASSERT_EQ(report.steps.size(), known.steps.size());
        for (std::size_t i = 0; i < known.steps.size(); ++i) {
            EXPECT_EQ(std::abs(*report.steps[i].icp_rad), std::abs(*known.steps[i].icp_rad));
            EXPECT_TRUE(report.steps[i].T->matrix() == known.steps[i].T->matrix());
            EXPECT_EQ(report.steps[i].sigma_rad, known.steps[i].sigma_rad);
        }
    }
    const TurnReport blind = solved(removed);
    EXPECT_EQ(blind.sign_source, SignSource::kAssumed);
    for (const TurnStep& step : blind.steps) {
        EXPECT_FALSE(step.error_rad);
        EXPECT_EQ(word(step.verdict), "accept") << step.sentence;
    }
}

TEST_F(ClosingTurn, SignComesFromTheHintElseFromTheRobot) {
    const std::vector<TurnView> some(turn_->views.begin(), turn_->views.begin() + 4);
    TurnSettings hinted;
    hinted.axis_hint = Eigen::Vector3d::UnitX();
    const TurnReport right = solved(some, hinted);
    EXPECT_EQ(right.sign_source, SignSource::kAxisHint);
    for (const TurnStep& step : right.steps) {
        EXPECT_GT(*step.icp_rad, 0.0);
        EXPECT_EQ(step.verdict, Verdict::kAccept);
    }
    hinted.axis_hint = -Eigen::Vector3d::UnitX();
    for (const TurnStep& step : solved(some, hinted).steps) {
        EXPECT_LT(*step.icp_rad, 0.0);
        EXPECT_EQ(step.verdict, Verdict::kReject);
        EXPECT_EQ(word(step.cause), "sign") << step.sentence;
    }
    auto backwards = some;
    for (TurnView& view : backwards) {
        view.joint6_rad = -*view.joint6_rad;
        view.commanded_rad = -*view.commanded_rad;
    }
    // Without a hint a wrong sign cannot be claimed: the positive direction is the robot's.
    const TurnReport mirrored = solved(backwards);
    EXPECT_EQ(mirrored.sign_source, SignSource::kJoint);
    for (const TurnStep& step : mirrored.steps) {
        EXPECT_LT(*step.icp_rad, 0.0);
        EXPECT_EQ(step.verdict, Verdict::kAccept) << step.sentence;
    }
}

TEST_F(ClosingTurn, PaperIcpRunsAndErrsMore) {
    const std::vector<TurnView> some(turn_->views.begin(), turn_->views.begin() + 8);
    TurnSettings settings;
    settings.method = TurnMethod::kPaperIcp;
    const TurnReport paper = solved(some, settings);
    ASSERT_EQ(paper.steps.size(), 7U);
    for (const TurnStep& step : paper.steps) {
        EXPECT_TRUE(step.icp_rad);
        EXPECT_FALSE(step.sigma_rad) << "it has no uncertainty";
    }
    EXPECT_GT(mean_error_deg(paper, 10.0), 3.0 * mean_error_deg(solved(some), 10.0));
}

}  // namespace
}  // namespace gripscan
