// The cell check as a table: facts of a sound cell pass everything, and each change to them fails
// the one item it is about.
#include "core/procedure/cell_check.h"

#include <gmock/gmock.h>

#include <functional>
#include <numbers>
#include <string>

#include "core/base/units.h"
#include "tests/unit/procedure/cell_bench.h"

namespace gripscan::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CellFacts sound_cell() {
    CellFacts facts;
    facts.link = LinkFacts{true, {}, {0.012, 0.020, 0.035}};
    ControllerState controller;
    controller.automatic = controller.servo_on = true;
    controller.override_percent = 100;
    facts.controller = controller;
    facts.joints_rad = JointAngles{0.0, 0.1, 0.0, 0.2, -0.5, -std::numbers::pi};
    facts.volume =
        VolumeFacts{80.0, "(-150, -90, 620) mm in the right image", 0.85, 140.0, true, 0.0012};
    facts.image = ImageFacts{0.001, 110.0, 8.5, 0.24, 21000, 0.1, 0.5};
    facts.apart = std::vector<Piece>{};
    facts.far_apart = std::vector<Piece>{};
    facts.still = std::vector<Piece>{};
    facts.still_at_arm = std::vector<Piece>{};
    facts.sweep = SweepFacts{0.080, 0.230};
    facts.disk = DiskFacts{80'000'000'000, 1'228'800};
    facts.time = TimeFacts{0.3, 0.1, 0.5};
    return facts;
}

const std::vector<Piece> kThing{{{0.012, -0.040, 0.700}, 500e-6}};

struct Case {
    std::string name;
    std::function<void(CellFacts&, TurnPlan&)> change;
    std::vector<std::string> fails;
    std::string says;
};

const std::vector<Case>& table() {
    static const std::vector<Case> cases{
        {"nothing wrong", [](CellFacts&, TurnPlan&) {}, {}, "AUTO"},
        {"the link is slow",
         [](CellFacts& f, TurnPlan&) { f.link->round_trips_s[1] = 0.6; },
         {"link"},
         "600.0 ms"},
        {"the link is dead",
         [](CellFacts& f, TurnPlan&) {
             f.link = LinkFacts{false, "no answer within 1 s", {}};
             f.controller = unknown("the robot does not answer");
             f.joints_rad = unknown("the robot does not answer");
         },
         {"link"},
         "no answer within 1 s"},
        {"emergency stop",
         [](CellFacts& f, TurnPlan&) { f.controller->emergency_stop = true; },
         {"controller"},
         "emergency stop"},
        {"fault",
         [](CellFacts& f, TurnPlan&) { f.controller->fault = true; },
         {"controller"},
         "fault"},
        {"not in AUTO",
         [](CellFacts& f, TurnPlan&) { f.controller->automatic = false; },
         {"controller"},
         "not in AUTO"},
        {"servo off",
         [](CellFacts& f, TurnPlan&) { f.controller->servo_on = false; },
         {"controller"},
         "servo off"},
        {"still moving",
         [](CellFacts& f, TurnPlan&) { f.controller->moving = true; },
         {"controller"},
         "moving"},
        {"override 0",
         [](CellFacts& f, TurnPlan&) { f.controller->override_percent = 0; },
         {"controller"},
         "override 0 %"},
        {"joint 5 beyond its range",
         [](CellFacts& f, TurnPlan&) { (*f.joints_rad)[4] = rad_from_deg(121.0); },
         {"joints"},
         "joint 5"},
        {"the elbow beyond its own range",
         [](CellFacts& f, TurnPlan&) {
             (*f.joints_rad)[1] = rad_from_deg(130.0);
             (*f.joints_rad)[2] = rad_from_deg(101.0);
         },
         {"joints"},
         "joint 3"},
        {"the turn does not fit from the planned start",
         [](CellFacts& f, TurnPlan& p) {
             (*f.joints_rad)[5] = p.start_joint6_rad.emplace(rad_from_deg(5.0));
         },
         {"range"},
         "from 5.0 to 365.0 deg"},
        {"the cable is twisted from where it hangs",
         [](CellFacts& f, TurnPlan& p) {
             (*f.joints_rad)[5] = rad_from_deg(-20.0);
             p.start_joint6_rad = 0.0;
         },
         {"cable"},
         "380 deg"},
        {"a corner outside an image",
         [](CellFacts& f, TurnPlan&) { f.volume->margin_px = -3.0; },
         {"volume"},
         "in the right image"},
        {"too far for the baseline",
         [](CellFacts& f, TurnPlan&) { f.volume->far_sd_m = 0.0024; },
         {"depth"},
         "2.40 mm"},
        {"out of the matcher's range",
         [](CellFacts& f, TurnPlan&) { f.volume->can_be_matched = false; },
         {"depth"},
         "out of what can be matched"},
        {"glare",
         [](CellFacts& f, TurnPlan&) { f.image->saturated = 0.05; },
         {"exposure"},
         "5.00 %"},
        {"dark",
         [](CellFacts& f, TurnPlan&) { f.image->brightness = 12.0; },
         {"brightness"},
         "light the gripper"},
        {"no texture",
         [](CellFacts& f, TurnPlan&) { f.image->contrast = 2.2; },
         {"texture"},
         "2.2 levels"},
        {"not matched", [](CellFacts& f, TurnPlan&) { f.image->fill = 0.04; }, {"fill"}, "4 %"},
        {"nothing there",
         [](CellFacts& f, TurnPlan&) { f.image->points = 900; },
         {"surface"},
         "900 points"},
        {"something stood still",
         [](CellFacts& f, TurnPlan&) { f.still = kThing; },
         {"alone"},
         "500 mm² at (12, -40, 700) mm"},
        {"something far apart before the warm-up",
         [](CellFacts& f, TurnPlan&) {
             f.still = unknown("nothing was turned");
             f.apart = f.far_apart = kThing;
         },
         {"alone"},
         "far apart"},
        {"something near before the warm-up may be a finger",
         [](CellFacts& f, TurnPlan&) {
             f.still = unknown("nothing was turned");
             f.apart = kThing;
         },
         {},
         "the warm-up will tell"},
        {"a joint in the region",
         [](CellFacts& f, TurnPlan&) { f.still_at_arm = kThing; },
         {"joint"},
         "arm's side"},
        {"the wrist in the region",
         [](CellFacts& f, TurnPlan&) { f.wrist_distance_m = 0.02; },
         {"joint"},
         "20 mm outside"},
        {"no room to turn",
         [](CellFacts& f, TurnPlan&) { f.sweep->free_radius_m = 0.095; },
         {"sweep"},
         "15 mm"},
        {"a full disk",
         [](CellFacts& f, TurnPlan&) { f.disk->free_bytes = 300'000'000; },
         {"disk"},
         "300 MB free, the session may take 373 MB"},
    };
    return cases;
}

class CellCheckTable : public testing::TestWithParam<std::size_t> {};

TEST_P(CellCheckTable, FailsTheItemThatIsWrongAndNoOther) {
    const Case& c = table()[GetParam()];
    SCOPED_TRACE(c.name);
    CellFacts facts = sound_cell();
    TurnPlan plan;
    c.change(facts, plan);
    const CellReport report = assess(facts, plan);
    EXPECT_EQ(failed_items(report), c.fails) << text_of(report);
    EXPECT_EQ(report.passed(), c.fails.empty());
    EXPECT_THAT(text_of(report), HasSubstr(c.says));
    for (const CellCheckItem& item : report.items) EXPECT_FALSE(item.sentence.empty());
}
INSTANTIATE_TEST_SUITE_P(Table, CellCheckTable, testing::Range<std::size_t>(0, table().size()));

TEST(CellCheck, SkipsWithTheReasonWhatIsNotKnownAndStillReportsEveryItem) {
    const CellReport known = assess(sound_cell(), {});
    const CellReport nothing = assess(CellFacts{}, {});
    ASSERT_EQ(known.items.size(), nothing.items.size());
    for (std::size_t i = 0; i < nothing.items.size(); ++i) {
        EXPECT_EQ(nothing.items[i].name, known.items[i].name);
        // A region that nobody has looked at is no pass.
        EXPECT_EQ(nothing.items[i].outcome, nothing.items[i].name == "surface"
                                                ? CheckOutcome::kFailed
                                                : CheckOutcome::kSkipped);
        EXPECT_THAT(nothing.items[i].sentence, testing::StartsWith("not measured: "));
    }
}

TEST(CellCheck, LetsADryRunAndAnOperatorWhoJogsPassWithoutAUTO) {
    CellFacts facts = sound_cell();
    facts.controller->automatic = false;
    TurnPlan plan;
    plan.mode = MotionMode::kDry;
    EXPECT_EQ(item_of(assess(facts, plan), "controller").outcome, CheckOutcome::kWarned);
    plan.mode = MotionMode::kManual;
    EXPECT_EQ(item_of(assess(facts, plan), "controller").outcome, CheckOutcome::kSkipped);
    plan.mode = MotionMode::kLive;
    EXPECT_EQ(item_of(assess(facts, plan), "controller").outcome, CheckOutcome::kFailed);
}

TEST(CellCheck, LaysTheTurnEvenlyAboutZeroWhereItDoesNotFitFromWhereTheArmStands) {
    CellFacts facts = sound_cell();
    (*facts.joints_rad)[5] = rad_from_deg(3.0);
    const CellReport report = assess(facts, {});
    EXPECT_EQ(item_of(report, "range").outcome, CheckOutcome::kPassed);
    EXPECT_THAT(item_of(report, "range").sentence, HasSubstr("from -180.0 to 180.0 deg"));
}

TEST(CellCheck, WarnsOfALongTurnAndCountsMotionAndPictures) {
    TurnPlan plan;
    plan.speed_percent = 1.0;  // 7.2 deg/s
    CellFacts facts = sound_cell();
    // 37 × (10° / 7.2 deg/s + 0.5 + 0.3 + 0.1 + 0.5 s) + 360° / 7.2 deg/s
    EXPECT_NEAR(item_of(assess(facts, plan), "duration").value,
                (37 * (10.0 / 7.2 + 1.4) + 50.0) / 60.0, 1e-9);
    facts.time->compute_s = 200.0;
    EXPECT_EQ(item_of(assess(facts, plan), "duration").outcome, CheckOutcome::kWarned);
}

}  // namespace
}  // namespace gripscan::test
