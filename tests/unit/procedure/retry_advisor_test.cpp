// The advice for every cause, by how often it was tried, at the floor of the step or above, locked
// or free; and that following the advice always ends.
#include "core/procedure/retry_advisor.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "tests/unit/procedure/advisor_rows.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;

/// Advice for a step of 10° and at the floor, after 0, 1, 2 earlier pictures with the same cause.
struct CauseRow {
    Cause cause;
    std::array<AdvisedAction, 3> rejected;
    std::array<AdvisedAction, 3> rejected_at_floor;
    std::array<AdvisedAction, 3> checked_at_floor;
};

const std::vector<CauseRow>& cause_table() {
    static const std::vector<CauseRow> table{
        {Cause::kOverlap, {kHalve, kHalve, kHalve}, {kStop, kStop, kStop}, {kGoOn, kGoOn, kGoOn}},
        {Cause::kSymmetry,
         {kLockAxis, kLockAxis, kLockAxis},
         {kLockAxis, kLockAxis, kLockAxis},
         {kLockAxis, kLockAxis, kLockAxis}},
        {Cause::kTexture,
         {kRetake, kRetake, kStop},
         {kRetake, kRetake, kStop},
         {kRetake, kGoOn, kGoOn}},
        {Cause::kExposure,
         {kRetake, kRetake, kStop},
         {kRetake, kRetake, kStop},
         {kRetake, kGoOn, kGoOn}},
        {Cause::kSettle,
         {kRetake, kRetake, kStop},
         {kRetake, kRetake, kStop},
         {kRetake, kGoOn, kGoOn}},
        {Cause::kWrongJoint, {kStop, kStop, kStop}, {kStop, kStop, kStop}, {kStop, kStop, kStop}},
        {Cause::kRatio, {kStop, kStop, kStop}, {kStop, kStop, kStop}, {kStop, kStop, kStop}},
        {Cause::kBacklash, {kStop, kStop, kStop}, {kStop, kStop, kStop}, {kStop, kStop, kStop}},
        {Cause::kSign, {kStop, kStop, kStop}, {kStop, kStop, kStop}, {kStop, kStop, kStop}},
        {Cause::kSlip, {kRetake, kStop, kStop}, {kRetake, kStop, kStop}, {kRetake, kGoOn, kGoOn}},
        {Cause::kLoose, {kRetake, kStop, kStop}, {kRetake, kStop, kStop}, {kRetake, kGoOn, kGoOn}},
        {Cause::kMovedCamera,
         {kRetake, kStop, kStop},
         {kRetake, kStop, kStop},
         {kRetake, kStop, kStop}},
        {Cause::kDepthDistortion,
         {kStop, kStop, kStop},
         {kStop, kStop, kStop},
         {kStop, kStop, kStop}},
        {Cause::kNotConverged,
         {kRetake, kHalve, kHalve},
         {kRetake, kStop, kStop},
         {kRetake, kGoOn, kGoOn}},
        {Cause::kLink, {kStop, kStop, kStop}, {kStop, kStop, kStop}, {kStop, kStop, kStop}},
    };
    return table;
}

TEST(RetryAdvisor, DecidesForEveryCauseAsTheTableSays) {
    const double floor_deg = deg_from_rad(TurnPlan{}.least_step_rad) * 1.9;
    for (const CauseRow& expected : cause_table()) {
        SCOPED_TRACE(std::string(word(expected.cause)));
        for (std::size_t made = 0; made < 3; ++made) {
            SCOPED_TRACE(made);
            const JudgedStep bad = rejected(expected.cause);
            const JudgedStep poor = checked(expected.cause, 0.0, floor_deg);
            const JudgedStep small = rejected(expected.cause, 0.0, floor_deg);
            const Advice above = advice_for(bad, {accepted()}, Rows(made, bad));
            const Advice at_floor = advice_for(small, {accepted()}, Rows(made, small), floor_deg);
            const Advice shown = advice_for(poor, {accepted()}, Rows(made, poor), floor_deg);
            EXPECT_EQ(word(above.action), word(expected.rejected[made]));
            EXPECT_EQ(word(at_floor.action), word(expected.rejected_at_floor[made]));
            EXPECT_EQ(word(shown.action), word(expected.checked_at_floor[made]));
            EXPECT_EQ(above.cause, expected.cause);
        }
    }
}

TEST(RetryAdvisor, SaysInOneSentenceWhatAndWhyAndShowsTheNumbersTheWorstFirst) {
    JudgedStep step = rejected(Cause::kOverlap, 0.2);
    step.row.overlap = 0.25;
    step.row.sentence = "overlap 25 %, limit 40 %: the step is too large";
    const Advice advice = advice_for(step, {}, {});
    EXPECT_EQ(advice.sentence,
              "Halve the step to 5.00 deg: the two views share too little surface (overlap 25 %, "
              "limit 40 %: the step is too large)");
    ASSERT_EQ(advice.evidence.size(), 5U);
    EXPECT_EQ(advice.evidence[0], "overlap 25 %, least 40 %");
    EXPECT_EQ(advice.evidence[1], "angle error +0.200 deg, limit 0.500 deg");
}

TEST(RetryAdvisor, ShowsWhatTheRegistrationFoundBeforeTheRowsOwnNumbers) {
    JudgedStep step = rejected(Cause::kExposure);
    step.evidence = {"glare 9.0 %, limit 2.0 %"};
    EXPECT_THAT(advice_for(step, {}, {}).evidence,
                testing::ElementsAre("glare 9.0 %, limit 2.0 %"));
}

TEST(RetryAdvisor, HalvesNoMoreOftenThanTheBudgetAllows) {
    const JudgedStep step = rejected(Cause::kOverlap, 0.0, 40.0);
    TurnPlan plan;
    plan.step_rad = rad_from_deg(80.0);
    plan.halvings_a_turn = 2;
    EXPECT_EQ(advice_for(step, {}, {}, 80.0, false, plan).action, kHalve);
    EXPECT_EQ(advice_for(step, {}, {}, 40.0, false, plan).action, kHalve);
    EXPECT_NE(advice_for(step, {}, {}, 20.0, false, plan).action, kHalve) << "to a fourth already";
    plan.halvings_a_turn.reset();  // down to the least step
    EXPECT_EQ(advice_for(step, {}, {}, 20.0, false, plan).action, kHalve);
    EXPECT_EQ(advice_for(step, {}, {}, 5.0, false, plan).action, kHalve);
    EXPECT_NE(advice_for(step, {}, {}, 3.0, false, plan).action, kHalve) << "below the floor";
}

TEST(RetryAdvisor, NeverHalvesASymmetricPartAndGoesOnOnceItIsLocked) {
    const JudgedStep blind = rejected(Cause::kSymmetry);
    EXPECT_EQ(advice_for(blind, {}, {}).action, kLockAxis);
    EXPECT_EQ(advice_for(blind, {}, {}, kStep_deg, true).action, kGoOn);
    EXPECT_EQ(advice_for(checked(Cause::kSymmetry), {}, {}, kStep_deg, true).action, kGoOn);
}

/// A surface that hardly shows its turn looks best unturned; a picture more would say the same.
TEST(RetryAdvisor, LocksAtOnceWhereTheWarmUpHasShownNoTurn) {
    const Advice advice =
        advice_for(wrong(-10.2), {}, {}, kStep_deg, false, {}, "observability 0.03, least 0.08");
    EXPECT_EQ(advice.action, kLockAxis);
    EXPECT_EQ(advice.cause, Cause::kSymmetry);
    EXPECT_THAT(advice.sentence, HasSubstr("observability 0.03"));
    EXPECT_EQ(advice_for(wrong(-10.2), {}, {}).action, kRetake) << "nothing is known of it";
}

TEST(RetryAdvisor, GoesOnWhereARowIsOnlyNotIndependent) {
    JudgedStep locked = checked(Cause::kNone);
    locked.row.mode = TurnMode::kAxisLocked;
    locked.row.independent = false;
    EXPECT_EQ(advice_for(locked, Rows(6, locked), {}, kStep_deg, true).action, kGoOn);
}

TEST(RetryAdvisor, StopsAtOnceForAnythingForeignAndSaysWhereItIs) {
    for (const Cause cause : {Cause::kNone, Cause::kMislabelled, Cause::kOverlap, Cause::kLoose}) {
        JudgedStep step = rejected(cause, 3.0);
        step.foreign = ForeignObject{{0.012, -0.040, 0.700}, 220.0};
        // Attempts that agree on a wrong angle would otherwise be the play of a joint.
        for (const auto& attempts : {std::vector<JudgedStep>{}, {step, step}}) {
            const Advice advice = advice_for(step, {accepted()}, attempts);
            EXPECT_EQ(advice.action, kStop);
            EXPECT_EQ(advice.cause, cause);
            EXPECT_THAT(advice.sentence, HasSubstr("220 mm² at (12, -40, 700) mm"));
            EXPECT_THAT(advice.sentence, HasSubstr("clear the registration area"));
        }
    }
}

TEST(RetryAdvisor, StopsWhereTheSameTroubleComesTwoStepsInARow) {
    EXPECT_EQ(
        advice_for(checked(Cause::kTexture), {checked(Cause::kTexture)}, {checked(Cause::kTexture)})
            .action,
        kStop);
    const Advice loose = advice_for(checked(Cause::kSlip), {accepted(), checked(Cause::kSlip)}, {});
    EXPECT_EQ(loose.action, kStop);
    EXPECT_EQ(loose.cause, Cause::kLoose);
    EXPECT_THAT(loose.sentence, HasSubstr("tighten the gripper on the flange"));
}

/// Everything the registration might say, at random; it knows nothing of the advisor.
JudgedStep any_step(SeededRandom& random, double step_rad) {
    constexpr int kCauses = 17;
    const auto upto = [&](int n) { return static_cast<int>(random.uniform(0.0, n - 1e-9)); };
    const double error_deg = std::array{0.0, 0.3, 0.8, -0.8, 2.0, -20.0}[upto(6)];
    JudgedStep step = row(static_cast<Verdict>(upto(3)), static_cast<Cause>(upto(kCauses)),
                          error_deg, deg_from_rad(step_rad));
    if (random.uniform(0.0, 1.0) < 0.2) step.row.icp_rad = step.row.error_rad = std::nullopt;
    if (random.uniform(0.0, 1.0) < 0.3) step.row.tilt_rad = rad_from_deg(3.0);
    step.row.independent = random.uniform(0.0, 1.0) < 0.8;
    return step;
}

/// What is left to spend, the larger unit first: angle to go, the lock, the step, pictures.
using Budget = std::tuple<double, int, double, int>;

TEST(RetryAdvisor, LeavesLessToSpendWithEveryAdviceThatIsFollowed) {
    const TurnPlan plan;
    int stopped = 0;
    int completed = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        SeededRandom random(seed);
        double to_go_rad = plan.total_rad;
        double step_rad = plan.step_rad;
        bool locked = false;
        const std::string unseen = seed % 5 == 0 ? "observability 0.03" : "";
        Rows before, attempts;
        const auto pictures_left = [&] {
            return plan.retakes_an_angle -
                   static_cast<int>(std::count_if(
                       attempts.begin(), attempts.end(), [&](const JudgedStep& attempt) {
                           return std::abs(*attempt.row.commanded_rad - step_rad) < 1e-9;
                       }));
        };
        const auto budget = [&] {
            return Budget{to_go_rad, locked ? 0 : 1, step_rad, pictures_left()};
        };
        AdvisedAction action = kGoOn;
        while (action != kStop && to_go_rad > 1e-9) {
            const Budget had = budget();
            const bool healthy = random.uniform(0.0, 1.0) < (seed % 2 == 0 ? 0.98 : 0.3);
            const JudgedStep step =
                healthy ? row(Verdict::kAccept, Cause::kNone, 0.02, deg_from_rad(step_rad))
                        : any_step(random, step_rad);
            action = advise({step, before, attempts, step_rad, locked, unseen}, plan).action;
            if (action == kRetake || action == kHalve) attempts.push_back(step);
            if (action == kHalve) step_rad *= 0.5;
            if (action == kLockAxis) locked = true;
            if (action == kGoOn) {
                to_go_rad -= step_rad;
                step_rad = plan.step_rad;
                before.push_back(step);
                attempts.clear();
            }
            if (action == kStop) break;
            ASSERT_LT(budget(), had) << word(action);
            ASSERT_GE(pictures_left(), 0);
            ASSERT_GE(step_rad, plan.least_step_rad);
        }
        (action == kStop ? stopped : completed) += 1;
    }
    // Both ends must have been seen for the property to mean anything.
    EXPECT_GT(stopped, 500);
    EXPECT_GT(completed, 100);
}

TEST(RetryAdvisor, GoesThroughATurnOfAcceptedAndNowAndThenGlaringSteps) {
    Rows before;
    for (int k = 0; k < 36; ++k) {
        if (k % 5 == 4) {
            EXPECT_EQ(advice_for(rejected(Cause::kExposure), before, {}).action, kRetake);
        }
        EXPECT_EQ(advice_for(accepted(), before, {}).action, kGoOn);
        before.push_back(accepted());
    }
}

}  // namespace
}  // namespace gripscan::test
