// Causes that only all steps together show: a sign turned round, one ratio in all of them.
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/registration/turn_check.h"

namespace gripscan {
namespace {

/// Steps whose scans turn by ratio · robot, accepted or rejected as a single step would be.
std::vector<TurnStep> steps_with(double ratio, int count = 9, double robot_deg = 10.0) {
    std::vector<TurnStep> steps;
    for (int i = 0; i < count; ++i) {
        TurnStep step;
        step.index = i + 1;
        step.robot_rad = rad_from_deg(robot_deg);
        const double noise_deg = 0.04 * (i % 3 - 1);
        step.icp_rad = rad_from_deg(ratio * robot_deg + noise_deg);
        step.error_rad = *step.icp_rad - *step.robot_rad;
        step.sigma_rad = rad_from_deg(0.03);
        step.overlap = 0.8;
        StepEvidence evidence;
        evidence.found = true;
        judge_step(step, evidence, {});
        steps.push_back(step);
    }
    return steps;
}

void expect_all(const std::vector<TurnStep>& steps, Verdict verdict, Cause cause) {
    for (const TurnStep& step : steps) {
        EXPECT_EQ(word(step.verdict), word(verdict)) << step.index << ": " << step.sentence;
        EXPECT_EQ(word(step.cause), word(cause)) << step.index << ": " << step.sentence;
    }
}

TEST(CommonCause, AgreementIsLeftAlone) {
    auto steps = steps_with(1.0);
    find_common_cause(steps, {}, std::nullopt);
    expect_all(steps, Verdict::kAccept, Cause::kNone);
}

TEST(CommonCause, SignTurnedRound) {
    auto steps = steps_with(-1.0);
    find_common_cause(steps, {}, std::nullopt);
    expect_all(steps, Verdict::kReject, Cause::kSign);
    EXPECT_NE(steps[0].sentence.find("other way round"), std::string::npos);
}

TEST(CommonCause, OneWrongSignIsNoCommonCause) {
    auto steps = steps_with(1.0);
    steps[4] = steps_with(-1.0, 5)[4];
    find_common_cause(steps, {}, std::nullopt);
    EXPECT_EQ(steps[4].cause, Cause::kMislabelled);
    EXPECT_EQ(steps[3].verdict, Verdict::kAccept);
}

TEST(CommonCause, GearRatioShowsInTheSteps) {
    for (const double ratio : {0.5, 0.85, 1.15, 2.0}) {
        auto steps = steps_with(ratio);
        find_common_cause(steps, {}, std::nullopt);
        expect_all(steps, Verdict::kReject, Cause::kRatio);
    }
}

TEST(CommonCause, OneMislabelledStepIsNoRatio) {
    auto steps = steps_with(1.0);
    steps[4] = steps_with(2.0, 5)[4];
    find_common_cause(steps, {}, std::nullopt);
    EXPECT_EQ(steps[4].cause, Cause::kMislabelled);
    EXPECT_EQ(steps[0].cause, Cause::kNone);
}

TEST(CommonCause, ScaleOfTheJointSolutionIsNamed) {
    auto steps = steps_with(1.02);  // 0.2 degrees a step: no single step shows it
    expect_all(steps, Verdict::kAccept, Cause::kNone);
    find_common_cause(steps, {}, 1.02);
    expect_all(steps, Verdict::kCheck, Cause::kRatio);
    EXPECT_NE(steps[0].sentence.find("1.0200"), std::string::npos) << steps[0].sentence;
}

TEST(CommonCause, HarmlessScaleIsNoFault) {
    auto steps = steps_with(1.0);
    find_common_cause(steps, {}, 1.0029);
    expect_all(steps, Verdict::kAccept, Cause::kNone);
}

TEST(CommonCause, TwoStepsAreTooFew) {
    auto steps = steps_with(-1.0, 2);
    find_common_cause(steps, {}, std::nullopt);
    expect_all(steps, Verdict::kReject, Cause::kMislabelled);
}

}  // namespace
}  // namespace gripscan
