#include "core/session/session_spec.h"

#include <gmock/gmock.h>

namespace gripscan {
namespace {

using testing::HasSubstr;

std::string problem(const std::string& more) {
    const auto spec =
        parse_session_spec("s/session.yaml", "format: gripscan-session/1\nkind: gripper\n" + more);
    return spec ? "no problem" : spec.error().message;
}

TEST(SessionSpec, ReadsEverythingOfTheContract) {
    const auto spec = parse_session_spec(
        "s.yaml",
        "format: gripscan-session/1\nkind: object\nstep_deg: 7.66   # nominal\n"
        "region: {min: [-0.1, -0.2, 0.5], max: [0.1, 0.2, 0.9]}\naxis_hint: [0, 0, 2]\n"
        "gripper_template: ../gripper/results/template.pcd\n"
        "limits: {angle_deg: 0.25, sigmas: 4, overlap: 0.5, slip_mm: 0.5, tilt_deg: 1}\n");
    ASSERT_TRUE(spec) << spec.error().message;
    EXPECT_EQ(spec->kind, SessionKind::kObject);
    EXPECT_EQ(spec->step_deg, 7.66);
    EXPECT_EQ(spec->region->min_m, Eigen::Vector3d(-0.1, -0.2, 0.5));
    EXPECT_EQ(*spec->axis_hint, Eigen::Vector3d(0, 0, 1));
    EXPECT_EQ(spec->gripper_template, "../gripper/results/template.pcd");
    EXPECT_EQ(spec->limits.angle_deg, 0.25);
    EXPECT_EQ(spec->limits.tilt_deg, 1.0);
}

TEST(SessionSpec, DefaultsAreTheContracts) {
    const auto spec = parse_session_spec("s.yaml",
                                         "format: gripscan-session/1\nkind: gripper\n"
                                         "limits: {slip_mm: 2}\n");
    ASSERT_TRUE(spec) << spec.error().message;
    EXPECT_EQ(spec->limits.angle_deg, 0.5);
    EXPECT_EQ(spec->limits.sigmas, 3.0);
    EXPECT_EQ(spec->limits.overlap, 0.4);
    EXPECT_EQ(spec->limits.slip_mm, 2.0);
    EXPECT_EQ(spec->limits.tilt_deg, 2.0);
    EXPECT_FALSE(spec->region);
    EXPECT_FALSE(spec->step_deg);
}

TEST(SessionSpec, ReadsWhatItWrites) {
    SessionSpec spec;
    spec.kind = SessionKind::kObject;
    spec.step_deg = 0.1 + 0.2;
    spec.region = Box{{-1.0 / 3.0, -0.2, 0.1}, {0.1, 0.2, 1e-1 + 1.0}};
    spec.axis_hint = Eigen::Vector3d(0.6, 0.0, 0.8);
    spec.gripper_template = "Prüf \"stück\"\\1: #a.pcd";
    spec.limits.sigmas = 2.5;
    const auto again = parse_session_spec("s.yaml", session_spec_text(spec));
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->step_deg, spec.step_deg);
    EXPECT_EQ(again->region->min_m, spec.region->min_m);
    EXPECT_EQ(again->region->max_m, spec.region->max_m);
    EXPECT_EQ(again->gripper_template, spec.gripper_template);
    EXPECT_EQ(again->limits.sigmas, 2.5);
    EXPECT_EQ(session_spec_text(*again), session_spec_text(spec));
}

TEST(SessionSpec, SaysWhatIsWrongAndWhere) {
    EXPECT_THAT(problem("step_deg: ten\n"), HasSubstr("s/session.yaml:3: step_deg"));
    EXPECT_THAT(problem("step_deg: '10'\n"), HasSubstr("finite number"));
    EXPECT_THAT(problem("step_deg: .nan\n"), HasSubstr("finite number"));
    EXPECT_THAT(problem("step_deg: 0\n"), HasSubstr("must not be 0"));
    EXPECT_THAT(problem("step_deg: [10]\n"), HasSubstr("finite number"));
    EXPECT_THAT(problem("step_degrees: 10\n"), HasSubstr(":3: unknown key 'step_degrees'"));
    EXPECT_THAT(problem("\nlimits: {angle: 1}\n"), HasSubstr(":4: unknown key 'limits.angle'"));
    EXPECT_THAT(problem("limits: {overlap: 1.5}\n"), HasSubstr("limits.overlap"));
    EXPECT_THAT(problem("limits: 3\n"), HasSubstr("limits must hold"));
    EXPECT_THAT(problem("region: {min: [0, 0, 1], max: [1, 0, 2]}\n"), HasSubstr("is empty"));
    EXPECT_THAT(problem("region: {min: [0, 0], max: [1, 1, 2]}\n"), HasSubstr("3 numbers"));
    EXPECT_THAT(problem("region: {min: [0, 0, 0]}\n"), HasSubstr("needs 'min' and 'max'"));
    EXPECT_THAT(problem("axis_hint: [0, 0, 0]\n"), HasSubstr("must be a direction"));
    EXPECT_THAT(problem("kind: object\n"), HasSubstr("kind is given twice"));
    EXPECT_THAT(problem("gripper_template: a.pcd\n"), HasSubstr("kind object"));
    EXPECT_THAT(problem("step_deg: [1\n"), HasSubstr("not valid YAML"));
}

TEST(SessionSpec, RefusesOtherFormatsAndKinds) {
    const auto text_problem = [](const std::string& text) {
        const auto spec = parse_session_spec("s.yaml", text);
        return spec ? std::string("no problem") : spec.error().message;
    };
    EXPECT_THAT(text_problem("kind: gripper\n"), HasSubstr("format is missing"));
    EXPECT_THAT(text_problem("format: gripscan-session/2\nkind: gripper\n"),
                HasSubstr("s.yaml:1: format is 'gripscan-session/2'"));
    EXPECT_THAT(text_problem("format: gripscan-session/1\nkind: claw\n"),
                HasSubstr("s.yaml:2: kind is 'claw'"));
    EXPECT_THAT(text_problem("- a list\n"), HasSubstr("key: value"));
    EXPECT_THAT(text_problem(""), HasSubstr("key: value"));
}

}  // namespace
}  // namespace gripscan
