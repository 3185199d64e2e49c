#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/sim/exchange_faults.h"
#include "core/sim/step_faults.h"

namespace gripscan::sim {
namespace {

constexpr double kStart_deg = -180.0;

StepFaults faults(const std::vector<std::string>& texts, std::uint64_t seed = 7) {
    return {parse_faults(texts).value(), rad_from_deg(kStart_deg), rad_from_deg(10.0), seed};
}

double at(double turned_deg) {
    return rad_from_deg(kStart_deg + turned_deg);
}

TEST(FaultPlan, HasADefaultForEveryNameOfTheContract) {
    for (const char* name :
         {"delay",     "drop",    "garble", "split",    "halfopen", "restart", "estop",
          "servo_off", "limit",   "ratio",  "backlash", "sign",     "loose",   "slip",
          "glare",     "defocus", "bump",   "intruder", "tool",     "shift"}) {
        const auto fault = parse_fault(name);
        ASSERT_TRUE(fault) << fault.error().message;
        EXPECT_EQ(info_of(fault->kind).name, name);
        EXPECT_EQ(*fault, info_of(fault->kind).preset);
    }
    EXPECT_EQ(fault_table().size(), 22U);
    for (std::size_t i = 0; i < fault_table().size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(fault_table()[i].preset.kind), i);
    }
}

TEST(FaultPlan, ReadsStepValueAndPoint) {
    EXPECT_EQ(parse_fault("slip@7=1.5").value(), (Fault{FaultKind::kSlip, 7, 1.5}));
    EXPECT_EQ(parse_fault("ratio=0.9").value(), (Fault{FaultKind::kRatio, 1, 0.9}));
    EXPECT_EQ(parse_fault("drop@3=after_done").value(),
              (Fault{FaultKind::kDrop, 3, 0.0, ExchangePoint::kAfterDone}));
    EXPECT_EQ(parse_fault("delay=0.25").value(),
              (Fault{FaultKind::kDelay, 5, 0.25, ExchangePoint::kAccept}));
    EXPECT_EQ(parse_fault("estop@0=state:2").value(),
              (Fault{FaultKind::kEmergencyStop, 0, 2.0, ExchangePoint::kState}));
}

TEST(FaultPlan, SaysWhatIsWrong) {
    const std::pair<const char*, const char*> cases[] = {
        {"gremlin", "there are delay, drop"}, {"slip@x", "no number from 0"},
        {"slip@-1", "no number from 0"},      {"slip@1.5", "no number from 0"},
        {"slip=much", "from -20 to 20 mm"},   {"ratio=7", "from 0.5 to 2"},
        {"sign=2", "takes no amount"},        {"drop=lunch", "there are hello, state"},
        {"drop=done:3", "takes no amount"},   {"delay=lunch:3", "there are hello"},
        {"", "no fault is called ''"}};
    for (const auto& [text, words] : cases) {
        const auto fault = parse_fault(text);
        ASSERT_FALSE(fault) << text;
        EXPECT_NE(fault.error().message.find(words), std::string::npos) << fault.error().message;
    }
}

TEST(StepFaults, TurnTheJointOtherwiseThanItsEncoderSays) {
    struct Case {
        const char* fault;
        double turned_deg;
        bool rising;
        double true_deg;
    };
    const Case cases[] = {
        {"ratio", 100.0, true, 105.0},        {"ratio@5", 40.0, true, 40.0},
        {"ratio@5=1.1", 60.0, true, 62.0},    {"sign", 30.0, true, -30.0},
        {"sign@3", 20.0, true, 20.0},         {"sign@3", 30.0, true, 10.0},
        {"backlash@5", 40.0, true, 40.0},     {"backlash@5", 50.0, true, 49.2},
        {"backlash@5=0.5", 45.0, true, 44.5}, {"backlash@5", 360.0, true, 359.2},
        {"backlash@5", 40.0, false, 39.2},    {"backlash@5", 50.0, false, 50.0},
        {"ratio", -50.0, true, -50.0},        {"slip", 90.0, true, 90.0},
    };
    for (const Case& c : cases) {
        const double true_rad = faults({c.fault}).true_joint6_rad(at(c.turned_deg), c.rising);
        EXPECT_NEAR(deg_from_rad(true_rad) - kStart_deg, c.true_deg, 1e-9)
            << c.fault << " at " << c.turned_deg;
    }
    // Without faults not a bit changes.
    EXPECT_EQ(StepFaults().true_joint6_rad(1.2345, true), 1.2345);
}

TEST(StepFaults, BeginWithTheirStepAndStay) {
    for (const double turned_deg : {0.0, 40.0, 42.0}) {
        const StepFaults all =
            faults({"slip", "loose", "bump", "intruder", "defocus", "tool", "shift"});
        EXPECT_EQ(all.T_tool_part(at(turned_deg)).matrix(), Pose::Identity().matrix());
        EXPECT_EQ(all.T_camera_moved(at(turned_deg)).matrix(), Pose::Identity().matrix());
        EXPECT_EQ(all.intruder_m(at(turned_deg)), 0.0);
        EXPECT_EQ(all.defocus_px(at(turned_deg)), 0.0);
        EXPECT_EQ(all.tool_m(at(turned_deg)), 0.0);
        EXPECT_EQ(all.surroundings_shift_m(at(turned_deg)).norm(), 0.0);
    }
    for (const double turned_deg : {45.0, 50.0, 360.0}) {
        EXPECT_NEAR(faults({"slip"}).T_tool_part(at(turned_deg)).translation().z(), 0.0025, 1e-12);
        const Pose bumped = faults({"bump"}).T_camera_moved(at(turned_deg));
        EXPECT_NEAR(bumped.translation().norm(), 0.004, 1e-12);
        EXPECT_NEAR(deg_from_rad(rotation_angle_rad(bumped.linear())), 0.4, 1e-9);
        EXPECT_EQ(bumped.matrix(), faults({"bump"}).T_camera_moved(at(50.0)).matrix());
        EXPECT_EQ(faults({"intruder"}).intruder_m(at(turned_deg)), 0.040);
        EXPECT_EQ(faults({"defocus"}).defocus_px(at(turned_deg)), 4.0);
        EXPECT_EQ(faults({"tool"}).tool_m(at(turned_deg)), 0.150);
        EXPECT_NEAR(faults({"shift"}).surroundings_shift_m(at(turned_deg)).norm(), 0.002, 1e-12);
    }
}

TEST(StepFaults, ALooseGripperStandsOtherwiseAtEveryAngleButTheSameAtTheSame) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const StepFaults loose = faults({"loose@1"}, seed);
        for (int step = 1; step <= 36; ++step) {
            const Pose here = loose.T_tool_part(at(10.0 * step));
            const double tilt_deg = deg_from_rad(rotation_angle_rad(here.linear()));
            EXPECT_GE(tilt_deg, 0.8 * 3.0 - 1e-9);
            EXPECT_LE(tilt_deg, 1.2 * 3.0 + 1e-9);
            EXPECT_NEAR(rotation_vector(here.linear()).z(), 0.0, 1e-12);
            EXPECT_LE(here.translation().norm(), 0.001);
            EXPECT_EQ(here.matrix(), loose.T_tool_part(at(10.0 * step) + 1e-12).matrix());
            EXPECT_NE(here.matrix(), loose.T_tool_part(at(10.0 * step + 10.0)).matrix());
            // Nothing 0.2 m from the flange moves further than is said.
            const Eigen::Vector3d far_m(0.0, 0.05, std::sqrt(0.04 - 0.0025));
            EXPECT_LE((here * far_m - far_m).norm(), loose.slack_m(0.2));
        }
    }
}

TEST(StepFaults, GlareComesOnceAtItsStep) {
    const StepFaults glare = faults({"glare@3"});
    EXPECT_EQ(glare.glare_px(at(30.0), 1), 45.0);
    EXPECT_EQ(glare.glare_px(at(30.0), 2), 0.0);
    for (const double turned_deg : {20.0, 25.0, 35.0, 40.0, 390.0}) {
        EXPECT_EQ(glare.glare_px(at(turned_deg), 1), 0.0);
    }
}

TEST(ExchangeFaults, StrikeOnceAtTheirTurnAndPoint) {
    ExchangeFaults faults(
        parse_faults({"drop@2=done", "estop@2", "slip", "garble@0=hello"}).value());
    EXPECT_EQ(faults.take_of_link(ExchangePoint::kHello)->kind, FaultKind::kGarble);
    EXPECT_FALSE(faults.take_of_link(ExchangePoint::kHello));
    faults.count_turn();
    EXPECT_FALSE(faults.take_of_link(ExchangePoint::kDone));
    EXPECT_FALSE(faults.take_of_controller(ExchangePoint::kRun));
    faults.count_turn();
    EXPECT_FALSE(faults.take_of_link(ExchangePoint::kRun));
    EXPECT_EQ(faults.take_of_controller(ExchangePoint::kRun)->kind, FaultKind::kEmergencyStop);
    EXPECT_EQ(faults.take_of_link(ExchangePoint::kDone)->kind, FaultKind::kDrop);
    EXPECT_FALSE(faults.take_of_link(ExchangePoint::kDone));
}

}  // namespace
}  // namespace gripscan::sim
