#include "core/recognition/exam.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/unit/recognition/part_templates.h"

namespace gripscan {
namespace {

Pose shifted(const Pose& T, const Eigen::Vector3d& by) {
    Pose moved = T;
    moved.translation() += by;
    return moved;
}

TEST(Exam, MeasuresAShiftAsItsLength) {
    const auto model = test::model_of(test::asymmetric_part(1), "part");
    const Pose T = turn_about(test::cell_axis(), 0.4);
    const auto m = measure_pose(*model, shifted(T, {0.003, 0.0, 0.004}), T);
    EXPECT_NEAR(m.add_m, 0.005, 1e-6);
    EXPECT_NEAR(m.mssd_m, 0.005, 1e-6);
    EXPECT_LE(m.add_s_m, m.add_m);
    EXPECT_NEAR(m.turn_rad, 0.0, 1e-7);
}

TEST(Exam, ForgivesTheTurnsOfASymmetricPart) {
    const auto model = test::model_of(test::part_of_revolution(1, 0.0), "turned");
    const Pose truth = test::part_turned(test::cell_axis(), 0.0);
    const Pose turned = truth * turn_about({{0, 0, 0}, Eigen::Vector3d::UnitX()}, 1.3);
    const auto m = measure_pose(*model, turned, truth);
    EXPECT_GT(m.add_m, 0.01);
    // The axis is found from points 1.2 mm apart.
    EXPECT_LT(m.mssd_m, 0.002);
    EXPECT_LT(m.add_s_m, 0.002);
}

TEST(Exam, OneMissedAngleIsANo) {
    const auto model = test::model_of(test::asymmetric_part(1), "part");
    std::vector<ExamAnswer> answers(3);
    for (auto& a : answers) a.T_estimated = a.T_expected;
    EXPECT_TRUE(judge_exam(*model, answers, {}, for_each_in_order).passed);
    answers[1].T_estimated = std::nullopt;
    const ExamResult missed = judge_exam(*model, answers, {}, for_each_in_order);
    EXPECT_FALSE(missed.passed);
    EXPECT_EQ(missed.sentence.substr(0, 3), "no:");
    answers[1].T_estimated = shifted(answers[1].T_expected, {0.004, 0, 0});
    EXPECT_FALSE(judge_exam(*model, answers, {}, for_each_in_order).passed);
    EXPECT_FALSE(judge_exam(*model, {}, {}, for_each_in_order).passed);
}

}  // namespace
}  // namespace gripscan
