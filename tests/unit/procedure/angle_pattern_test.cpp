// What a wrong angle is taken for, by the rows before it and the earlier attempts at it.
#include "core/procedure/angle_pattern.h"

#include <gmock/gmock.h>

#include <string>

#include "tests/unit/procedure/advisor_rows.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;

struct AngleCase {
    std::string name;
    JudgedStep step;
    Rows before;
    Rows attempts;
    double step_deg;
    AdvisedAction action;
    Cause cause;
};

JudgedStep tilted(double error_deg) {
    JudgedStep step = wrong(error_deg);
    step.row.tilt_rad = rad_from_deg(2.5);
    return step;
}

const std::vector<AngleCase>& angle_table() {
    const Rows fine(3, accepted());
    static const std::vector<AngleCase> table{
        {"a first wrong angle is looked at again",
         wrong(1.4),
         fine,
         {},
         10,
         kRetake,
         Cause::kMislabelled},
        {"again the same, after good steps: play",
         wrong(1.4),
         fine,
         {wrong(1.42)},
         10,
         kStop,
         Cause::kBacklash},
        {"again the same, in the first step: a smaller one will tell",
         wrong(1.4),
         {},
         {wrong(1.42)},
         10,
         kHalve,
         Cause::kBacklash},
        {"the error halved with the step: ratio",
         wrong(0.7, 5),
         {},
         {wrong(1.4), wrong(1.42)},
         5,
         kStop,
         Cause::kRatio},
        {"the error stayed: play",
         wrong(1.4, 5),
         {},
         {wrong(1.4), wrong(1.42)},
         5,
         kStop,
         Cause::kBacklash},
        {"no smaller step is left: play, the best supported",
         wrong(1.0, 3),
         {},
         {wrong(1.02, 3)},
         3,
         kStop,
         Cause::kBacklash},
        {"a different error at the same angle: once more",
         wrong(1.4),
         fine,
         {wrong(-2.1)},
         10,
         kRetake,
         Cause::kLoose},
        {"and different again: loose",
         wrong(1.4),
         fine,
         {wrong(-2.1), wrong(3.0)},
         10,
         kStop,
         Cause::kLoose},
        {"the same error with a tilted axis: loose",
         tilted(1.4),
         fine,
         {tilted(1.4)},
         10,
         kStop,
         Cause::kLoose},
        {"three steps by one ratio",
         wrong(1.0),
         {wrong(1.03), wrong(0.97)},
         {},
         10,
         kStop,
         Cause::kRatio},
        {"three steps by one ratio, two of them accepted",
         checked(Cause::kMislabelled, 0.52),
         {accepted(0.47), accepted(0.48)},
         {},
         10,
         kStop,
         Cause::kRatio},
        {"two steps by one ratio are no proof",
         checked(Cause::kMislabelled, 0.52),
         {accepted(0.48)},
         {},
         10,
         kRetake,
         Cause::kMislabelled},
        {"three steps now one way, now the other",
         wrong(-2.0),
         {wrong(1.2), wrong(3.0)},
         {},
         10,
         kStop,
         Cause::kLoose},
        {"this step undoes the one before: one capture is wrong",
         wrong(-1.41),
         {accepted(), wrong(1.4)},
         {},
         10,
         kGoOn,
         Cause::kMislabelled},
        {"the same turn the other way: look again",
         wrong(-20.0),
         {},
         {},
         10,
         kRetake,
         Cause::kSign},
        {"and again the other way: sign",
         wrong(-20.0),
         {},
         {wrong(-20.03)},
         10,
         kStop,
         Cause::kSign},
        {"a little wrong twice: shown, and its cause named",
         checked(Cause::kMislabelled, 0.8),
         fine,
         {checked(Cause::kMislabelled, 0.8)},
         10,
         kGoOn,
         Cause::kBacklash},
        {"nothing turned is no play",
         wrong(-9.98, 10),
         {},
         {wrong(-9.97, 10)},
         3,
         kGoOn,
         Cause::kMislabelled},
    };
    return table;
}

class WrongAngle : public testing::TestWithParam<std::size_t> {};

TEST_P(WrongAngle, IsReadFromRowsAndAttempts) {
    const AngleCase& expected = angle_table()[GetParam()];
    SCOPED_TRACE(expected.name);
    const Advice advice =
        advice_for(expected.step, expected.before, expected.attempts, expected.step_deg);
    EXPECT_EQ(word(advice.action), word(expected.action)) << advice.sentence;
    EXPECT_EQ(word(advice.cause), word(expected.cause)) << advice.sentence;
}

INSTANTIATE_TEST_SUITE_P(Table, WrongAngle, testing::Range<std::size_t>(0, angle_table().size()));

TEST(RetryAdvisor, DoesNotCountOverlapOrGlareAsEvidenceAboutTheRobot) {
    const Rows spoilt{rejected(Cause::kOverlap, 1.0), rejected(Cause::kExposure, 1.0)};
    const Advice advice = advice_for(wrong(1.0), spoilt, {});
    EXPECT_EQ(advice.cause, Cause::kMislabelled);
    EXPECT_EQ(advice.action, kRetake);
}

TEST(RetryAdvisor, StopsAfterTooManyRejectedRowsInARow) {
    // Nothing turned, again and again: no pattern names it, but it must not go on for ever.
    const JudgedStep still = wrong(-9.98);
    const Rows again{still};
    TurnPlan plan;
    plan.least_step_rad = rad_from_deg(kStep_deg);
    Rows before;
    for (int row = 1; row < plan.rejected_in_a_row; ++row) {
        EXPECT_EQ(advice_for(still, before, again, kStep_deg, false, plan).action, kGoOn);
        before.push_back(still);
    }
    const Advice last = advice_for(still, before, again, kStep_deg, false, plan);
    EXPECT_EQ(last.action, kStop);
    EXPECT_THAT(last.sentence, HasSubstr("3 steps in a row are rejected"));
}

}  // namespace
}  // namespace gripscan::test
