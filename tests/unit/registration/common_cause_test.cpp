// Causes that only all steps together show: a sign turned round, one ratio in all of them.
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/registration/common_cause.h"
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

/// Judges step i anew with an error added to what the scans say.
void set_error(std::vector<TurnStep>& steps, std::size_t i, double error_deg) {
    TurnStep& step = steps[i];
    step.icp_rad = *step.robot_rad + rad_from_deg(error_deg);
    step.error_rad = rad_from_deg(error_deg);
    StepEvidence evidence;
    evidence.found = true;
    judge_step(step, evidence, {});
}

void set_slip(std::vector<TurnStep>& steps, std::size_t i, double slip_mm, double tilt_deg = 0.0) {
    TurnStep& step = steps[i];
    step.slip_m = slip_mm / kMmPerM;
    step.tilt_rad = rad_from_deg(tilt_deg);
    StepEvidence evidence;
    evidence.found = true;
    judge_step(step, evidence, {});
}

TEST(CommonCause, OneStepThatLacksALittleIsBacklash) {
    for (const double error_deg : {-1.2, 0.8, -2.8}) {
        auto steps = steps_with(1.0);
        set_error(steps, 4, error_deg);
        find_common_cause(steps, {}, std::nullopt);
        EXPECT_EQ(word(steps[4].cause), "backlash") << steps[4].sentence;
        EXPECT_NE(steps[4].verdict, Verdict::kAccept) << "naming a cause accepts nothing";
        EXPECT_EQ(word(steps[3].cause), "none");
        EXPECT_EQ(word(steps[5].cause), "none");
    }
}

TEST(CommonCause, TheNextStepMakesUpForBacklash) {
    auto steps = steps_with(1.0);
    set_error(steps, 3, -1.3);
    set_error(steps, 4, 1.25);
    find_common_cause(steps, {}, std::nullopt);
    EXPECT_EQ(word(steps[3].cause), "backlash");
    EXPECT_EQ(word(steps[4].cause), "backlash");
    EXPECT_NE(steps[3].sentence.find("cancel"), std::string::npos) << steps[3].sentence;
}

TEST(CommonCause, MoreThanAJointCanLoseIsAnotherCapture) {
    auto steps = steps_with(1.0);
    set_error(steps, 3, -9.0);
    set_error(steps, 4, 9.0);
    find_common_cause(steps, {}, std::nullopt);
    EXPECT_EQ(word(steps[3].cause), "mislabelled");
    EXPECT_EQ(word(steps[4].cause), "mislabelled");
}

TEST(CommonCause, WrongAnglesInARowAreNoBacklash) {
    auto steps = steps_with(1.0);
    for (const std::size_t i : {2U, 3U, 4U}) set_error(steps, i, -1.5);
    find_common_cause(steps, {}, std::nullopt);
    for (const std::size_t i : {2U, 3U, 4U}) EXPECT_EQ(word(steps[i].cause), "mislabelled") << i;
}

TEST(CommonCause, OneSlipIsASlip) {
    auto steps = steps_with(1.0);
    set_slip(steps, 4, 3.0);
    find_common_cause(steps, {}, std::nullopt);
    EXPECT_EQ(word(steps[4].cause), "slip");
}

TEST(CommonCause, SlippingOnAndOnIsSlip) {
    auto steps = steps_with(1.0);
    for (const std::size_t i : {2U, 4U, 6U}) set_slip(steps, i, 2.5);
    find_common_cause(steps, {}, std::nullopt);
    for (const std::size_t i : {2U, 4U, 6U}) EXPECT_EQ(word(steps[i].cause), "slip") << i;
}

TEST(CommonCause, ToAndFroIsLoose) {
    auto steps = steps_with(1.0);
    set_slip(steps, 2, 2.5);
    set_slip(steps, 3, -2.0);
    set_slip(steps, 6, 0.2, 5.0);
    find_common_cause(steps, {}, std::nullopt);
    for (const std::size_t i : {2U, 3U, 6U}) EXPECT_EQ(word(steps[i].cause), "loose") << i;
}

TEST(CommonCause, AClosedTurnTellsDistortedDepthFromARatio) {
    auto steps = steps_with(1.08);
    find_common_cause(steps, {}, std::nullopt, true);
    for (const TurnStep& step : steps) {
        EXPECT_EQ(word(step.cause), "depth_distortion") << step.sentence;
        EXPECT_EQ(step.verdict, Verdict::kCheck);
    }
    steps = steps_with(1.08);
    find_common_cause(steps, {}, std::nullopt, false);
    expect_all(steps, Verdict::kCheck, Cause::kRatio);
    steps = steps_with(1.08);
    find_common_cause(steps, {}, 1.08, true);
    expect_all(steps, Verdict::kCheck, Cause::kRatio);
}

}  // namespace
}  // namespace gripscan
