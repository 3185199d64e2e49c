// From evidence to one cause: the outermost one is named, with value and limit; what does no harm
// of the older view is noted only.
#include "core/registration/diagnosis.h"

#include <gmock/gmock.h>

#include <functional>

#include "core/base/units.h"
#include "core/registration/evidence_lines.h"
#include "core/registration/quality.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

struct Judged {
    TurnStep step;
    StepEvidence evidence;
};

Judged good() {
    Judged j;
    j.step.to = 4;
    j.step.robot_rad = rad_from_deg(10.0);
    j.step.icp_rad = rad_from_deg(10.1);
    j.step.error_rad = rad_from_deg(0.1);
    j.step.sigma_rad = rad_from_deg(0.03);
    j.step.observability = 0.4;
    j.step.tilt_rad = rad_from_deg(0.3);
    j.step.slip_m = 0.1e-3;
    j.step.overlap = 0.8;
    j.step.T = Pose::Identity();
    j.evidence.found = true;
    j.evidence.least_observability = kLeastObservability;
    j.evidence.unexplained_limit_m2 = 500e-6;
    return j;
}

void error_deg(Judged& j, double deg) {
    j.step.error_rad = rad_from_deg(deg);
    j.step.icp_rad = *j.step.robot_rad + *j.step.error_rad;
}
void camera(Judged& j, double px) {
    j.evidence.camera_shift = CameraShift{px, 0.01, 0.98, 80};
}
void intruder(Judged& j, double mm2, double beside_mm2 = 20.0) {
    j.evidence.unexplained =
        Unexplained{900, 1e-6 * mm2, 0.042, {0.01, -0.06, 0.7}, 0.1, 1e-6 * beside_mm2};
    j.evidence.unexplained_in = 4;
}
void glare(Judged& j, bool hurts = false) {
    j.evidence.image_fault = ImageFault{Cause::kExposure, 3.0, "9.0 % over-exposed", hurts};
    j.evidence.image_fault_in = 4;
}

struct Case {
    std::string name;
    std::function<void(Judged&)> change;
    std::string verdict;
    std::string cause;
    std::string says;
};

class Diagnosis : public testing::TestWithParam<Case> {};

TEST_P(Diagnosis, AsTheTableSays) {
    const Case& c = GetParam();
    Judged j = good();
    c.change(j);
    diagnose_step(j.step, j.evidence, {});
    EXPECT_EQ(word(j.step.verdict), c.verdict) << j.step.sentence;
    EXPECT_EQ(word(j.step.cause), c.cause) << j.step.sentence;
    EXPECT_THAT(j.step.sentence, HasSubstr(c.says));
}

INSTANTIATE_TEST_SUITE_P(
    Table, Diagnosis,
    testing::Values(
        Case{"Good", [](Judged&) {}, "accept", "none", "agrees"},
        Case{"StillCamera", [](Judged& j) { camera(j, 0.3); }, "accept", "none", "agrees"},
        Case{"MovedCameraRejectsAGoodAngle", [](Judged& j) { camera(j, 5.2); }, "reject",
             "moved_camera", "5.20 px"},
        Case{"SmallPieceIsNoIntruder", [](Judged& j) { intruder(j, 300.0); }, "accept", "none", ""},
        Case{"IntruderRejectsAGoodAngle", [](Judged& j) { intruder(j, 1500.0); }, "reject",
             "mislabelled", "(10, -60, 700) mm, 42 mm large"},
        Case{"ManyPiecesAreNoIntruderButABadFit", [](Judged& j) { intruder(j, 600.0, 3000.0); },
             "accept", "none", ""},
        Case{"CameraBeforeIntruder",
             [](Judged& j) {
                 camera(j, 5.0);
                 intruder(j, 1500.0);
             },
             "reject", "moved_camera", ""},
        Case{"GlareInTheNewerViewWantsAnotherAttempt", [](Judged& j) { glare(j); }, "check",
             "exposure", "capture 4"},
        Case{"GlareInTheOlderViewIsNoted",
             [](Judged& j) {
                 glare(j);
                 j.step.from = j.evidence.image_fault_in = 3;
             },
             "accept", "none", "note: capture 3"},
        Case{"GlareExplainsAWrongAngle",
             [](Judged& j) {
                 glare(j);
                 error_deg(j, 0.7);
             },
             "check", "exposure", "9.0 % over-exposed; scans turned"},
        Case{"GlareThatLeavesNoSurface", [](Judged& j) { glare(j, true); }, "reject", "exposure",
             "capture 4"},
        Case{"GlareExplainsThatNothingWasFound",
             [](Judged& j) {
                 glare(j);
                 j.evidence.found = false;
             },
             "reject", "exposure", "no alignment"},
        Case{"AWrongJointIsNoGlare",
             [](Judged& j) {
                 glare(j);
                 error_deg(j, 3.0);
                 j.evidence.other_joints_moved_rad = rad_from_deg(0.5);
             },
             "reject", "wrong_joint", "note: capture 4"}),
    [](const auto& test) { return test.param.name; });

TEST(AxisLocked, AgreesButIsNotIndependent) {
    Judged j = good();
    j.step.mode = TurnMode::kAxisLocked;
    j.step.independent = false;
    j.step.observability = 0.01;
    error_deg(j, 0.0);
    j.evidence.misfit = 1.2;
    diagnose_step(j.step, j.evidence, {});
    EXPECT_EQ(word(j.step.verdict), "check");
    EXPECT_EQ(word(j.step.cause), "symmetry");
    EXPECT_THAT(j.step.sentence, HasSubstr("not measured"));
    j.evidence.misfit = 2.1 * 3.0;
    diagnose_step(j.step, j.evidence, {});
    EXPECT_EQ(word(j.step.verdict), "reject");
    EXPECT_THAT(j.step.sentence, HasSubstr("limit 3.0"));
}

TEST(EvidenceLines, SayWhatWasLookedAt) {
    Judged j = good();
    camera(j, 5.2);
    intruder(j, 300.0);
    const auto lines = evidence_lines(j.step, j.evidence, {});
    std::vector<std::string> exceeded;
    for (const EvidenceLine& line : lines) {
        EXPECT_FALSE(line.value.empty());
        EXPECT_FALSE(line.limit.empty());
        if (line.exceeded) exceeded.push_back(line.what);
    }
    EXPECT_THAT(exceeded, testing::ElementsAre("background"));
    EXPECT_GE(lines.size(), 9U);
    j.evidence.camera_shift.reset();
    for (const EvidenceLine& line : evidence_lines(j.step, j.evidence, {})) {
        EXPECT_FALSE(line.exceeded) << line.what;
        if (line.what == "background") {
            EXPECT_EQ(line.value, "not known");
        }
    }
    j.evidence.as_reported = Agreement{0.12, 0.02, 0.10};
    j.step.cause = Cause::kOverlap;
    const auto too_large = evidence_lines(j.step, j.evidence, {});
    EXPECT_THAT(too_large, testing::Contains(testing::AllOf(
                               testing::Field(&EvidenceLine::value, "12 %, and 2 % floats"),
                               testing::Field(&EvidenceLine::exceeded, true))));
}

}  // namespace
}  // namespace gripscan
