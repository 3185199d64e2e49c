// The verdict on a step: every criterion just inside its limit, below twice the limit, beyond.
#include "core/registration/turn_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "core/base/units.h"
#include "core/registration/quality.h"

namespace gripscan {
namespace {

TurnStep good_step() {
    TurnStep step;
    step.index = 3;
    step.robot_rad = rad_from_deg(10.0);
    step.icp_rad = rad_from_deg(10.1);
    step.error_rad = rad_from_deg(0.1);
    step.sigma_rad = rad_from_deg(0.03);
    step.observability = 0.4;
    step.tilt_rad = rad_from_deg(0.3);
    step.slip_m = 0.1e-3;
    step.overlap = 0.8;
    step.T = Pose::Identity();
    return step;
}

StepEvidence good_evidence() {
    StepEvidence evidence;
    evidence.found = true;
    evidence.least_observability = kLeastObservability;
    return evidence;
}

void set_error_deg(TurnStep& step, double deg) {
    step.error_rad = rad_from_deg(deg);
    step.icp_rad = *step.robot_rad + *step.error_rad;
}

using Change = std::function<void(TurnStep&, StepEvidence&)>;

struct Case {
    std::string name;
    Change change;
    std::string verdict;
    std::string cause;
    std::string says;  ///< part of the sentence
};

Change error_deg(double deg, double sigma_deg = 0.03) {
    return [=](TurnStep& s, StepEvidence&) {
        s.sigma_rad = rad_from_deg(sigma_deg);
        set_error_deg(s, deg);
    };
}
Change overlap(double share) {
    return [=](TurnStep& s, StepEvidence&) { s.overlap = share; };
}
Change slip_mm(double mm) {
    return [=](TurnStep& s, StepEvidence&) { s.slip_m = mm / kMmPerM; };
}
Change tilt_deg(double deg) {
    return [=](TurnStep& s, StepEvidence&) { s.tilt_rad = rad_from_deg(deg); };
}
Change with_joints(Change change, double other_deg, double joint6_deg) {
    return [=](TurnStep& s, StepEvidence& e) {
        change(s, e);
        e.other_joints_moved_rad = rad_from_deg(other_deg);
        e.joint6_moved_rad = rad_from_deg(joint6_deg);
    };
}
/// No answer, or several, where the views share so much under the robot's own turn.
Change not_found(Cause cause, double shared, double floating) {
    return [=](TurnStep&, StepEvidence& e) {
        e.found = false;
        e.cause_not_found = cause;
        e.as_reported = Agreement{shared, floating, shared - floating};
    };
}
Change starts_disagree(double shared) {
    return [=](TurnStep&, StepEvidence& e) {
        e.starts_agree = false;
        e.as_reported = Agreement{shared, 0.01, shared - 0.01};
    };
}
Change nothing() {
    return [](TurnStep&, StepEvidence&) {};
}

class JudgeStep : public testing::TestWithParam<Case> {};

TEST_P(JudgeStep, AsTheTableSays) {
    const Case& c = GetParam();
    TurnStep step = good_step();
    step.cause = Cause::kLink;  // must be overwritten
    StepEvidence evidence = good_evidence();
    c.change(step, evidence);
    judge_step(step, evidence, {});
    EXPECT_EQ(word(step.verdict), c.verdict) << step.sentence;
    EXPECT_EQ(word(step.cause), c.cause) << step.sentence;
    EXPECT_NE(step.sentence.find(c.says), std::string::npos) << step.sentence;
}

INSTANTIATE_TEST_SUITE_P(
    Table, JudgeStep,
    testing::Values(
        Case{"Good", nothing(), "accept", "none", "+0.100 deg"},
        Case{"AngleInside", error_deg(0.499), "accept", "none", "agrees"},
        Case{"AngleInsideNegative", error_deg(-0.499), "accept", "none", "-0.499"},
        Case{"AngleBelowTwice", error_deg(0.51), "check", "mislabelled", "limit 0.500"},
        Case{"AngleBelowTwiceNegative", error_deg(-0.99), "check", "mislabelled", "-0.990"},
        Case{"AngleBeyond", error_deg(1.01), "reject", "mislabelled", "+1.010"},
        Case{"AngleBeyondNegative", error_deg(-1.01), "reject", "mislabelled", "-1.010"},
        Case{"SigmaWidensTheLimit", error_deg(0.89, 0.3), "accept", "none", "agrees"},
        Case{"SigmaWidensTheCheck", error_deg(1.7, 0.3), "check", "mislabelled", "limit 0.900"},
        Case{"BeyondTwiceThreeSigma", error_deg(1.81, 0.3), "reject", "mislabelled", ""},
        Case{"OverlapInside", overlap(0.401), "accept", "none", ""},
        Case{"OverlapBelow", overlap(0.39), "check", "overlap", "39 %"},
        Case{"OverlapHalf", overlap(0.21), "check", "overlap", "limit 40 %"},
        Case{"OverlapBeyond", overlap(0.19), "reject", "overlap", "too large"},
        Case{"OverlapNone", overlap(0.0), "reject", "overlap", ""},
        Case{"SlipInside", slip_mm(-0.99), "accept", "none", ""},
        Case{"SlipBelowTwice", slip_mm(1.1), "check", "slip", "+1.10 mm"},
        Case{"SlipBeyond", slip_mm(-2.1), "reject", "slip", "-2.10 mm"},
        Case{"TiltInside", tilt_deg(1.99), "accept", "none", ""},
        Case{"TiltBelowTwice", tilt_deg(2.1), "check", "loose", "2.10 deg"},
        Case{"TiltBeyond", tilt_deg(4.1), "reject", "loose", "limit 2.00"},
        Case{"OtherJointExplainsTheAngle", with_joints(error_deg(3.0), 0.5, 0.0), "reject",
             "wrong_joint", "another joint"},
        Case{"JointSettlingMakesTheStepVoid", with_joints(error_deg(0.8), 0.0, 0.3), "reject",
             "settle", "during the exposure"},
        Case{"OtherJointBeforeSettling", with_joints(error_deg(3.0), 0.5, 0.3), "reject",
             "wrong_joint", ""},
        Case{"JointsThatMovedMakeItVoidThoughAllElseFits", with_joints(nothing(), 0.5, 0.3),
             "reject", "wrong_joint", ""},
        Case{"JointsThatStandStill", with_joints(error_deg(3.0), 0.015, 0.015), "reject",
             "mislabelled", ""},
        Case{"WorstIsNamed",
             [](TurnStep& s, StepEvidence&) {
                 set_error_deg(s, 0.6);
                 s.slip_m = 1.8e-3;
             },
             "check", "slip", "slip"},
        Case{"LowOverlapExplainsTheRest",
             [](TurnStep& s, StepEvidence&) {
                 set_error_deg(s, 3.0);
                 s.overlap = 0.35;
             },
             "reject", "overlap", "35 %"},
        Case{"NotFound", [](TurnStep&, StepEvidence& e) { e.found = false; }, "reject",
             "not_converged", "no alignment"},
        Case{"NotFoundInAStepTooLarge", not_found(Cause::kNotConverged, 0.12, 0.02), "reject",
             "overlap", "share 12 % of the surface, limit 40 %"},
        Case{"NotFoundThoughMuchIsShared", not_found(Cause::kNotConverged, 0.41, 0.02), "reject",
             "not_converged", "no alignment"},
        Case{"NotFoundAndTheRobotsTurnDoesNotFitEither",
             not_found(Cause::kNotConverged, 0.12, 0.07), "reject", "not_converged", ""},
        Case{"NothingToAlignIsNoLargeStep", not_found(Cause::kTexture, 0.12, 0.02), "reject",
             "texture", ""},
        Case{"StartsDisagreeInAStepTooLarge", starts_disagree(0.12), "reject", "overlap",
             "too large; different starts"},
        Case{"StartsDisagreeThoughMuchIsShared", starts_disagree(0.8), "reject", "symmetry", ""},
        Case{"Symmetric", [](TurnStep& s, StepEvidence&) { s.observability = 0.07; }, "reject",
             "symmetry", "0.07"},
        Case{"ObservabilityJustEnough", [](TurnStep& s, StepEvidence&) { s.observability = 0.081; },
             "accept", "none", ""},
        Case{"StoodStillAndHardlyShown",
             [](TurnStep& s, StepEvidence&) {
                 s.observability = 0.09;
                 set_error_deg(s, -9.9);
             },
             "reject", "symmetry", "hardly shows"},
        Case{"StoodStillThoughItWouldShow", error_deg(-9.9), "reject", "mislabelled", "region"},
        Case{"StartsDisagree", [](TurnStep&, StepEvidence& e) { e.starts_agree = false; }, "reject",
             "symmetry", "different starts"},
        Case{"NotIndependent", [](TurnStep& s, StepEvidence&) { s.independent = false; }, "check",
             "none", "independently"},
        Case{"NotIndependentAndBeyond",
             [](TurnStep& s, StepEvidence&) {
                 s.independent = false;
                 set_error_deg(s, 2.0);
             },
             "reject", "mislabelled", ""},
        Case{"NoAngleKnown",
             [](TurnStep& s, StepEvidence&) {
                 s.robot_rad.reset();
                 s.error_rad.reset();
             },
             "accept", "none", "not known"},
        Case{"PaperIcpHasNoSigma",
             [](TurnStep& s, StepEvidence& e) {
                 e.paper_icp = true;
                 s.sigma_rad.reset();
                 s.observability.reset();
                 set_error_deg(s, 4.0);
             },
             "reject", "not_converged", "limit 0.500"}),
    [](const auto& test) { return test.param.name; });

/// However well the surfaces agree: another joint that moved, or a joint that moved while the
/// picture was taken, is not the step that was asked for.
TEST(TurnCheck, AStepOfOtherJointsIsVoid) {
    for (const bool other : {true, false}) {
        TurnStep step = good_step();
        StepEvidence evidence = good_evidence();
        (other ? evidence.other_joints_moved_rad : evidence.joint6_moved_rad) = rad_from_deg(0.019);
        judge_step(step, evidence, TurnLimits{});
        EXPECT_EQ(step.verdict, Verdict::kAccept) << step.sentence;
        (other ? evidence.other_joints_moved_rad : evidence.joint6_moved_rad) = rad_from_deg(0.021);
        judge_step(step, evidence, TurnLimits{});
        EXPECT_EQ(step.verdict, Verdict::kReject);
        EXPECT_EQ(step.cause, other ? Cause::kWrongJoint : Cause::kSettle);
    }
}

}  // namespace
}  // namespace gripscan
