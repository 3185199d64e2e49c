// What the Recognise page says of what was found.
#include "ui/views/recognition_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/support/sample_snapshot.h"
#include "ui/theme/shown_number.h"

namespace gripscan::ui {
namespace {

using namespace gripscan::test;
using testing::HasSubstr;

FoundTemplate found(const std::string& name, TemplateKind kind) {
    FoundTemplate f;
    f.name = name;
    f.kind = kind;
    f.T_camera_template.translation() = Eigen::Vector3d(0.14296, 0.00849, 0.74299);
    f.T_camera_template.linear() = rotation_from_euler({0.1, 0.2, 0.3});
    f.score = 0.91;
    f.found = 0.88;
    f.rms_m = 0.23e-3;
    f.tolerance_m = 1e-3;
    return f;
}

Sample recognised(std::vector<FoundTemplate> all) {
    Sample sample = sample_finished();
    auto shown = std::make_shared<ShownRecognition>();
    shown->view = 3;
    shown->looked_for = 6;
    shown->least_score = 0.45;
    shown->least_found = 0.25;
    shown->found = std::move(all);
    sample.snapshot.recognition = std::move(shown);
    return sample;
}

TEST(RecognitionVerdict, SaysWhatIsMissingBeforeTheFirstView) {
    Sample sample = sample_finished();
    EXPECT_EQ(recognition_verdict(sample.snapshot).word, "The library is empty");
    sample.snapshot.library = {{"gripper", TemplateKind::kGripper, 1000, "none", "", ""}};
    EXPECT_EQ(recognition_verdict(sample.snapshot).state, State::kWaiting);
}

TEST(RecognitionVerdict, AcceptsWhatIsUniqueAndChecksWhatIsNot) {
    const auto gripper = found("two-finger", TemplateKind::kGripper);
    auto carton = found("carton", TemplateKind::kObject);
    EXPECT_EQ(recognition_verdict(recognised({}).snapshot).state, State::kCheck);
    const auto both = recognition_verdict(recognised({gripper, carton}).snapshot);
    EXPECT_EQ(both.state, State::kAccept);
    EXPECT_THAT(both.sentence, HasSubstr("two-finger and carton found"));
    carton.next_score = 0.90;
    const auto close = recognition_verdict(recognised({gripper, carton}).snapshot);
    EXPECT_EQ(close.state, State::kCheck);
    EXPECT_THAT(close.sentence, HasSubstr("carton fits nearly as well in another pose"));
}

TEST(RecognitionVerdict, AStrangeThingComesFirst) {
    Sample sample = recognised({found("carton", TemplateKind::kObject)});
    auto shown = std::make_shared<ShownRecognition>(*sample.snapshot.recognition);
    shown->strangers = {"something is in the way: 150 x 26 x 11 mm at x 12, y 83, z 640 mm"};
    sample.snapshot.recognition = shown;
    EXPECT_EQ(recognition_verdict(sample.snapshot).state, State::kCheck);
    EXPECT_EQ(recognition_verdict(sample.snapshot).sentence, shown->strangers[0]);
}

TEST(Poses, StandInEveryFrameThatIsKnown) {
    auto carton = found("carton", TemplateKind::kObject);
    EXPECT_EQ(poses_text(*recognised({carton}).snapshot.recognition).rows.size(), 1U);
    carton.T_gripper_template = Pose::Identity();
    carton.T_robot_template = carton.T_camera_template;
    const TableText text = poses_text(*recognised({carton}).snapshot.recognition);
    ASSERT_EQ(text.rows.size(), 3U);
    EXPECT_EQ(text.rows[0].cells[0].text, "carton");
    EXPECT_EQ(text.rows[0].cells[2].text, "142.96");
    EXPECT_EQ(text.rows[2].cells[1].text, "robot");
    EXPECT_EQ(text.rows[2].cells[1].emphasis, Emphasis::kStrong);
    EXPECT_EQ(text.rows[0].cells[5].text, shown_number(deg_from_rad(0.1), 2));
}

TEST(Poses, KeepFullPrecisionInTheClipboard) {
    auto carton = found("carton", TemplateKind::kObject);
    carton.T_camera_template.translation().x() = 0.123456789012;
    const std::string text = poses_for_clipboard(*recognised({carton}).snapshot.recognition);
    EXPECT_THAT(text, HasSubstr("123.4567890"));
}

TEST(Witness, ComparesTheJointWithTheGripper) {
    Sample sample = recognised({found("two-finger", TemplateKind::kGripper)});
    EXPECT_FALSE(witness_of(sample.snapshot));
    auto shown = std::make_shared<ShownRecognition>(*sample.snapshot.recognition);
    shown->joint6_robot_rad = rad_from_deg(-180.0);
    shown->joint6_gripper_rad = rad_from_deg(180.2);
    sample.snapshot.recognition = shown;
    const auto witness = witness_of(sample.snapshot);
    ASSERT_TRUE(witness);
    EXPECT_EQ(witness->difference_deg, "+0.200");
    EXPECT_EQ(witness->state, State::kAccept);
}

TEST(Evidence, NamesEachLimitOfTheRecogniser) {
    const Sample sample = recognised({found("carton", TemplateKind::kObject)});
    const auto rows = found_evidence(*sample.snapshot.recognition, 0);
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_EQ(rows[0].limit, 0.45);
    EXPECT_EQ(rows[0].state, State::kAccept);
    EXPECT_DOUBLE_EQ(rows[1].value, 88.0);
    EXPECT_EQ(rows[4].unit, "mm");
}

}  // namespace
}  // namespace gripscan::ui
