#include "core/recognition/recognise.h"

#include <gtest/gtest.h>

#include "core/concurrency/worker_pool.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/random_pose.h"
#include "tests/unit/recognition/part_templates.h"

namespace gripscan {
namespace {

using test::SolidPart;

// Noise of 0.2 mm, related over 3 px, over some thousand points leaves some hundredths of a
// millimetre and of a degree on parts of this size (about 100 mm); the rest of the limits is for
// templates sampled at 1.2 mm and for normals smoothed across edges.
constexpr double kDeg = 0.5;
constexpr double kMm = 0.5;

test::ViewSettings wide_view() {
    test::ViewSettings settings;
    settings.width_px = 320;
    settings.height_px = 240;
    return settings;
}

Pose somewhere(SeededRandom& random, double x_m) {
    Pose T = test::random_pose(random, 3.1);
    T.translation() = Eigen::Vector3d(x_m, random.uniform(-0.04, 0.04), random.uniform(0.55, 0.7));
    return T;
}

/// A wall behind and a box beside: points that belong to no template.
std::vector<std::pair<SolidPart, Pose>> clutter() {
    using enum test::Primitive::Kind;
    const SolidPart wall{{{kBox, Eigen::Vector3d::Zero(), {0.5, 0.5, 0.01}}}};
    const SolidPart box{{{kBox, Eigen::Vector3d::Zero(), {0.03, 0.025, 0.04}}}};
    Pose behind = Pose::Identity();
    behind.translation() = Eigen::Vector3d(0.0, 0.0, 0.85);
    Pose beside = Pose::Identity();
    beside.linear() = rotation_from_vector({0.4, 0.7, -0.3});
    beside.translation() = Eigen::Vector3d(0.02, 0.10, 0.62);
    return {{wall, behind}, {box, beside}};
}

// Shapes of their own: parts that differ in a detail only cannot be told apart from every side.
SolidPart angle_bracket() {
    using enum test::Primitive::Kind;
    return {{{kBox, {0.0, 0.0, 0.0}, {0.05, 0.022, 0.005}},
             {kBox, {-0.045, 0.0, 0.03}, {0.005, 0.022, 0.03}},
             {kBox, {0.03, 0.012, 0.012}, {0.012, 0.008, 0.010}}}};
}
SolidPart stepped_block() {
    using enum test::Primitive::Kind;
    return {{{kBox, {-0.02, 0.0, 0.0}, {0.03, 0.03, 0.025}},
             {kBox, {0.03, -0.010, -0.008}, {0.02, 0.018, 0.015}},
             {kCylinder, {-0.02, 0.008, 0.032}, {0.015, 0.012, 0.012}}}};
}

class Recognise : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        parts() = {test::asymmetric_part(1), angle_bracket(), stepped_block()};
        for (std::size_t i = 0; i < parts().size(); ++i) {
            models().push_back(test::model_of(parts()[i], fmt::format("part {}", i + 1)));
        }
    }
    static std::vector<SolidPart>& parts() {
        static std::vector<SolidPart> all;
        return all;
    }
    static std::vector<std::shared_ptr<const TemplateModel>>& models() {
        static std::vector<std::shared_ptr<const TemplateModel>> all;
        return all;
    }
};

/// Whatever is reported is there, and where it is said to be. A part that is not found is left to
/// the operator: one in eight may be.
TEST_F(Recognise, FindsThePartsThatAreThereAndNoOthers) {
    std::size_t right = 0;
    for (const std::uint64_t seed : {11, 12, 13, 14}) {
        SeededRandom random(seed);
        auto scene = clutter();
        const Pose T0 = somewhere(random, -0.09);
        const Pose T1 = somewhere(random, 0.10);
        scene.emplace_back(parts()[0], T0);
        scene.emplace_back(parts()[1], T1);
        const auto found = recognise(models(), test::view_of_all(scene, wide_view(), seed), {}, {},
                                     for_each_in_order);
        ASSERT_TRUE(found) << found.error().message;
        right += found->size();
        for (const Detection& d : *found) {
            ASSERT_LT(d.template_index, 2U) << "the third part is not in the scene";
            const Eigen::Vector3d centre = models()[d.template_index]->centre_m.cast<double>();
            EXPECT_THAT(d.T_camera_template,
                        test::IsPose(d.template_index == 0 ? T0 : T1, centre, kDeg, kMm))
                << d.name << ", seed " << seed << ": " << d.explained();
        }
    }
    EXPECT_GE(right, 7U);
}

TEST_F(Recognise, FindsAPartThatIsHalfHidden) {
    using enum test::Primitive::Kind;
    // Long across the view: the post hides the middle half of it, not all.
    Pose T = Pose::Identity();
    T.linear() = rotation_from_vector({0.5, 0.5, 0.3});
    T.translation() = Eigen::Vector3d(0.0, 0.0, 0.62);
    auto scene = clutter();
    scene.emplace_back(parts()[0], T);
    const SolidPart post{{{kBox, Eigen::Vector3d::Zero(), {0.02, 0.2, 0.005}}}};
    Pose in_front = Pose::Identity();
    in_front.translation() = Eigen::Vector3d(-0.01, 0.0, 0.45);
    scene.emplace_back(post, in_front);
    const auto found =
        recognise(models(), test::view_of_all(scene, wide_view(), 21), {}, {}, for_each_in_order);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 1U);
    const VisibleAgreement& agreement = found->front().agreement;
    EXPECT_GT(agreement.hidden, 0.35 * agreement.visible);
    EXPECT_THAT(found->front().T_camera_template,
                test::IsPose(T, models()[0]->centre_m.cast<double>(), 1.0, 1.0));
}

TEST_F(Recognise, FindsNothingWhereNothingIs) {
    const auto found = recognise(models(), test::view_of_all(clutter(), wide_view(), 31), {}, {},
                                 for_each_in_order);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->empty()) << found->front().name << ": " << found->front().explained();
}

TEST_F(Recognise, DoesNotDependOnTheNumberOfThreads) {
    SeededRandom random(41);
    auto scene = clutter();
    scene.emplace_back(parts()[2], somewhere(random, 0.0));
    const Cloud view = test::view_of_all(scene, wide_view(), 41);
    WorkerPool pool(3);
    const auto one = recognise(models(), view, {}, {}, for_each_in_order);
    const auto three = recognise(models(), view, {}, {}, pool.for_each());
    ASSERT_TRUE(one && three);
    ASSERT_EQ(one->size(), three->size());
    for (std::size_t i = 0; i < one->size(); ++i) {
        EXPECT_EQ((*one)[i].T_camera_template.matrix(), (*three)[i].T_camera_template.matrix());
        EXPECT_EQ((*one)[i].score, (*three)[i].score);
    }
}

TEST_F(Recognise, CanBeCancelled) {
    std::stop_source stop;
    stop.request_stop();
    const auto found = recognise(models(), test::view_of_all(clutter(), wide_view(), 51), {},
                                 Progress{stop.get_token(), {}}, for_each_in_order);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().kind, ErrorKind::kCancelled);
}

TEST(Symmetry, ACylinderIsTheSameAfterEveryTurn) {
    const auto model = test::model_of(test::part_of_revolution(1, 0.0), "turned");
    ASSERT_NE(model, nullptr);
    ASSERT_TRUE(model->symmetry.revolution) << model->symmetry.name;
    EXPECT_EQ(model->symmetry.name, "revolution");
    // Turned about x; the tolerance of a surface match on 120 mm is about a millimetre.
    EXPECT_GT(std::abs(model->symmetry.revolution->direction.x()), 0.999);
    EXPECT_LT(model->symmetry.revolution->distance_m({0, 0, 0}), 1e-3);
}

TEST(Symmetry, ABoxHasFourPosesAlikeAndAGripperNone) {
    using enum test::Primitive::Kind;
    const SolidPart box{{{kBox, Eigen::Vector3d::Zero(), {0.05, 0.035, 0.02}}}};
    const auto boxed = test::model_of(box, "box");
    ASSERT_NE(boxed, nullptr);
    EXPECT_EQ(boxed->symmetry.turns.size(), 3U) << boxed->symmetry.name;
    const auto gripper = test::model_of(test::asymmetric_part(5), "gripper");
    ASSERT_NE(gripper, nullptr);
    EXPECT_EQ(gripper->symmetry.name, "none");
}

TEST(Symmetry, TheNearestEquivalentPoseIsOneThatLooksTheSame) {
    Symmetry symmetry;
    symmetry.revolution = Axis{{0.01, 0.02, 0.0}, Eigen::Vector3d::UnitZ()};
    SeededRandom random(3);
    for (int trial = 0; trial < 50; ++trial) {
        const Pose truth = test::random_pose(random, 3.1);
        const Pose turned = truth * turn_about(*symmetry.revolution, random.uniform(-3.1, 3.1));
        const Pose back = nearest_equivalent(turned, symmetry, truth);
        EXPECT_LT((back.matrix() - truth.matrix()).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace gripscan
