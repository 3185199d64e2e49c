#include "core/sim/lens.h"

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "core/base/seeded_random.h"
#include "core/sim/cell_layout.h"

namespace gripscan::sim {
namespace {

TEST(Lens, ProjectsAsOpenCvDoes) {
    const StereoRig rig = default_rig();
    const Lens lens(rig.K_right, rig.D_right, rig.image);
    cv::Mat K;
    cv::eigen2cv(rig.K_right, K);
    SeededRandom random(3);
    for (int i = 0; i < 500; ++i) {
        const double z = random.uniform(0.5, 2.0);
        const Eigen::Vector3d p(random.uniform(-0.6, 0.6) * z, random.uniform(-0.45, 0.45) * z, z);
        std::vector<cv::Point2d> image;
        cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, cv::Vec3d(), cv::Vec3d(),
                          K, rig.D_right, image);
        const Eigen::Vector2d ours = lens.project(p);
        EXPECT_NEAR(ours.x(), image[0].x, 1e-9);
        EXPECT_NEAR(ours.y(), image[0].y, 1e-9);
    }
}

TEST(Lens, LooksWhereItProjects) {
    const StereoRig rig = default_rig();
    const Lens lens(rig.K_left, rig.D_left, rig.image);
    SeededRandom random(4);
    for (int i = 0; i < 2000; ++i) {
        const double u = random.uniform(-0.5, rig.image.width - 0.5);
        const double v = random.uniform(-0.5, rig.image.height - 0.5);
        const Eigen::Vector2d x =
            lens.direction_at(static_cast<float>(u), static_cast<float>(v)).cast<double>();
        const Eigen::Vector2d again = lens.project({x.x(), x.y(), 1.0});
        // Directions are floats, bilinear between pixel corners: a few ten-thousandths of a pixel.
        EXPECT_NEAR(again.x(), u, 5e-4);
        EXPECT_NEAR(again.y(), v, 5e-4);
    }
}

}  // namespace
}  // namespace gripscan::sim
