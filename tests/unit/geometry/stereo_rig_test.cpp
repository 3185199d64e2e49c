#include "core/geometry/stereo_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "core/base/seeded_random.h"
#include "core/base/units.h"

namespace gripscan {
namespace {

StereoRig good_rig() {
    StereoRig rig;
    rig.image = {1280, 960};
    rig.K_left << 985, 0, 640, 0, 985, 480, 0, 0, 1;
    rig.K_right = rig.K_left;
    rig.T_right_left.translation() = Eigen::Vector3d(-0.12, 0, 0);
    return rig;
}

TEST(StereoRig, AGoodOnePasses) {
    StereoRig rig = good_rig();
    EXPECT_TRUE(validate(rig));
    EXPECT_TRUE(rig.is_rectified());
    EXPECT_DOUBLE_EQ(rig.baseline_m(), 0.12);
    for (const std::size_t count : {4, 5, 8, 12, 14}) {
        rig.D_left.assign(count, 0.01);
        rig.D_right.assign(count, -0.01);
        EXPECT_TRUE(validate(rig)) << count;
        EXPECT_FALSE(rig.is_rectified());
    }
    rig.T_right_left.linear() = rotation_from_euler({0.01, 0.2, -0.02});
    rig.T_right_left.translation() = Eigen::Vector3d(-0.12, 0.003, 0.02);
    EXPECT_TRUE(validate(rig));
}

struct Fault {
    friend void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }
    std::string name;
    std::function<void(StereoRig&)> apply;
    std::string message_has;
};

class BadRig : public testing::TestWithParam<Fault> {};

TEST_P(BadRig, IsRefusedWithTheReason) {
    StereoRig rig = good_rig();
    GetParam().apply(rig);
    const Status status = validate(rig);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::kInput);
    EXPECT_THAT(status.error().message, testing::HasSubstr(GetParam().message_has));
}

void set_shift(StereoRig& rig, double x, double y, double z) {
    rig.T_right_left.translation() = Eigen::Vector3d(x, y, z);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Faults, BadRig,
    testing::Values(
        Fault{"NoSize",
              [](StereoRig& r) {
                  r.image = {0, 0};
              },
              "image_width"},
        Fault{"HugeSize", [](StereoRig& r) { r.image.width = 1000000; }, "image_width"},
        Fault{"NoFocalLength", [](StereoRig& r) { r.K_left(0, 0) = 0; }, "K1"},
        Fault{"NegativeFocalLength", [](StereoRig& r) { r.K_right(1, 1) = -985; }, "K2"},
        Fault{"NanInK", [](StereoRig& r) { r.K_right(0, 2) = kNan; }, "K2"},
        Fault{"Skew", [](StereoRig& r) { r.K_left(0, 1) = 3; }, "K1"},
        Fault{"Transposed", [](StereoRig& r) { r.K_left.transposeInPlace(); }, "K1"},
        Fault{"PrincipalPointFarOutside", [](StereoRig& r) { r.K_left(0, 2) = 5000; },
              "principal point"},
        Fault{"ThreeCoefficients", [](StereoRig& r) { r.D_left.assign(3, 0.0); }, "D1"},
        Fault{"SixCoefficients", [](StereoRig& r) { r.D_right.assign(6, 0.0); }, "D2"},
        Fault{"NanInD", [](StereoRig& r) { r.D_right.assign(5, kNan); }, "D2"},
        Fault{"ZeroBaseline", [](StereoRig& r) { set_shift(r, 0, 0, 0); }, "baseline"},
        Fault{"WrongSign", [](StereoRig& r) { set_shift(r, 0.12, 0, 0); }, "sign"},
        Fault{"Millimetres", [](StereoRig& r) { set_shift(r, -120, 0, 0); }, "millimetres"},
        Fault{"Upright", [](StereoRig& r) { set_shift(r, -0.01, -0.12, 0); }, "along x"},
        Fault{"NanInT", [](StereoRig& r) { set_shift(r, kNan, 0, 0); }, "R or T"},
        Fault{"NoRotation", [](StereoRig& r) { r.T_right_left.linear() *= 1.01; }, "rotation"},
        Fault{"Mirrored", [](StereoRig& r) { r.T_right_left.linear()(2, 2) = -1; }, "rotation"},
        Fault{"LooksElsewhere",
              [](StereoRig& r) {
                  r.T_right_left.linear() = rotation_from_euler({0, rad_from_deg(90), 0});
              },
              "deg apart"}),
    [](const auto& fault) { return fault.param.name; });

TEST(RectifiedRig, ProjectsAndTriangulatesBothWays) {
    const RectifiedRig rig{{1280, 960}, 985.0, 640.5, 655.25, 481.0, 0.12};
    SeededRandom random(1);
    for (int i = 0; i < 500; ++i) {
        const Eigen::Vector3d p(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3),
                                random.uniform(0.4, 2.0));
        const Eigen::Vector2d left = rig.project(p);
        const double disparity = rig.disparity_px(p.z());
        // The right camera sees the point where its own centre and the baseline put it.
        const double x_right = rig.f_px * (p.x() - rig.baseline_m) / p.z() + rig.cx_right_px;
        EXPECT_NEAR(left.x() - disparity, x_right, 1e-9);
        EXPECT_NEAR(rig.depth_m(disparity), p.z(), 1e-12);
        EXPECT_TRUE(rig.point_m(left.x(), left.y(), disparity).isApprox(p, 1e-12));
    }
}

}  // namespace
}  // namespace gripscan
