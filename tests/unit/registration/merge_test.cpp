// Views into one template: who saw a point, how well it is known, and what must not enter.
#include "core/registration/merge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random_pose.h"
#include "tests/support/synthetic_views.h"

namespace gripscan {
namespace {

using namespace test;

struct Views {
    std::vector<Cloud> clouds;
    std::vector<Pose> T_first_view;

    [[nodiscard]] std::vector<PosedView> posed() const {
        std::vector<PosedView> views;
        for (std::size_t k = 0; k < clouds.size(); ++k) {
            views.push_back({&clouds[k], T_first_view[k]});
        }
        return views;
    }
};

Views views_of(const SolidPart& part, int count, double step_rad, const ViewSettings& settings) {
    Views views;
    for (int k = 0; k < count; ++k) {
        views.clouds.push_back(view_of(part, part_turned(cell_axis(), k * step_rad), settings,
                                       static_cast<std::uint64_t>(k) + 1));
        views.T_first_view.push_back(turn_about(cell_axis(), -k * step_rad));
    }
    return views;
}

/// A plate that faces the camera.
SolidPart plate(double half_thickness_m) {
    return {{{Primitive::Kind::kBox, {0, 0, 0}, {0.03, 0.02, half_thickness_m}}},
            SolidTexture(1, 20.0)};
}

TEST(MergeViews, CountsTheViewsThatSawAPoint) {
    const Views views = views_of(plate(0.004), 5, 0.02, {});
    const Cloud merged = merge_views(views.posed(), {1e-3, 1}, for_each_in_order);
    ASSERT_EQ(merged.seen.size(), merged.size());
    ASSERT_EQ(merged.sigma.size(), merged.size());
    ASSERT_EQ(merged.normals.size(), merged.size());
    std::size_t by_all = 0;
    for (const auto seen : merged.seen) {
        EXPECT_GE(seen, 1);
        EXPECT_LE(seen, 5);
        by_all += seen == 5 ? 1 : 0;
    }
    EXPECT_GT(by_all, merged.size() * 8 / 10);
    for (const int least : {2, 5}) {
        for (const auto seen : merge_views(views.posed(), {1e-3, least}, for_each_in_order).seen) {
            EXPECT_GE(seen, least);
        }
    }
    EXPECT_TRUE(merge_views(views.posed(), {1e-3, 6}, for_each_in_order).empty());
    EXPECT_TRUE(merge_views({}, {}, for_each_in_order).empty());
}

/// n views of independent noise: the error of a point is noise / sqrt(n), less what neighbours add;
/// the noise is shared by about 3 px, as wide as the smoothing.
TEST(MergeViews, SigmaIsTheErrorThatIsLeft) {
    for (const int count : {4, 16}) {
        ViewSettings settings;
        settings.noise_m = 0.3e-3;
        const Views views = views_of(plate(0.004), count, 0.01, settings);
        const Cloud merged = merge_views(views.posed(), {1e-3, 2}, for_each_in_order);
        const Pose T = part_turned(cell_axis(), 0.0).inverse();
        double error = 0.0;
        double sigma = 0.0;
        std::size_t n = 0;
        for (std::size_t i = 0; i < merged.size(); ++i) {
            const Eigen::Vector3d p = T * merged.points[i].cast<double>();
            if (std::abs(p.x()) > 0.026 || std::abs(p.y()) > 0.016) continue;
            error += std::pow(std::abs(p.z()) - 0.004, 2);
            sigma += std::pow(merged.sigma[i], 2);
            ++n;
        }
        ASSERT_GT(n, 500U);
        error = std::sqrt(error / static_cast<double>(n));
        sigma = std::sqrt(sigma / static_cast<double>(n));
        EXPECT_LT(error, 1.1 * settings.noise_m / std::sqrt(count));
        EXPECT_GT(error / sigma, 0.3) << count;
        EXPECT_LT(error / sigma, 2.0) << count;
    }
}

TEST(MergeViews, DropsDebrisThatOtherViewsLookThrough) {
    Views views = views_of(plate(0.004), 8, 0.03, {});
    // The same flying patch in front of the plate in two views of eight.
    const Eigen::Vector3d debris = part_turned(cell_axis(), 0.0) * Eigen::Vector3d(0, 0, -0.02);
    for (const std::size_t k : {2, 3}) {
        Cloud& cloud = views.clouds[k];
        const Pose T = views.T_first_view[k].inverse();
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            const Eigen::Vector3d first = T.inverse() * cloud.points[i].cast<double>();
            if ((first - debris).head<2>().norm() > 0.003) continue;
            const float z = static_cast<float>((T * debris).z());
            cloud.points[i] *= z / cloud.points[i].z();
        }
    }
    const auto near_debris = [&](const Cloud& merged) {
        return std::count_if(merged.points.begin(), merged.points.end(), [&](const auto& p) {
            return (p.template cast<double>() - debris).norm() < 0.006;
        });
    };
    const Cloud merged = merge_views(views.posed(), {1e-3, 2}, for_each_in_order);
    EXPECT_EQ(near_debris(merged), 0);
    EXPECT_GT(merged.size(), 1500U);
    // With those two views alone nothing contradicts it.
    const auto all = views.posed();
    const std::vector<PosedView> two{all[2], all[3]};
    EXPECT_GT(near_debris(merge_views(two, {1e-3, 2}, for_each_in_order)), 5);
}

TEST(MergeViews, ThinWallKeepsBothSides) {
    // 0.8 mm of sheet in voxels of 1 mm, seen from the front and from behind.
    const SolidPart sheet = plate(0.4e-3);
    ViewSettings settings;
    settings.noise_m = 0.05e-3;
    Views views;
    for (int k = 0; k < 6; ++k) {
        const double angle = (k < 3 ? 0.0 : std::numbers::pi) + 0.03 * k;
        views.clouds.push_back(view_of(sheet, part_turned(cell_axis(), angle), settings,
                                       static_cast<std::uint64_t>(k)));
        views.T_first_view.push_back(turn_about(cell_axis(), -angle));
    }
    const Cloud merged = merge_views(views.posed(), {1e-3, 2}, for_each_in_order);
    const Pose T = part_turned(cell_axis(), 0.0).inverse();
    std::size_t front = 0;
    std::size_t back = 0;
    for (std::size_t i = 0; i < merged.size(); ++i) {
        const Eigen::Vector3d p = T * merged.points[i].cast<double>();
        const double n = (T.linear() * merged.normals[i].cast<double>()).z();
        if (std::abs(p.x()) > 0.026 || std::abs(p.y()) > 0.016) continue;
        // Every point on its own side, to a quarter of the sheet.
        EXPECT_NEAR(p.z(), std::copysign(0.4e-3, n), 0.2e-3);
        (n < 0.0 ? front : back) += 1;
    }
    EXPECT_GT(front, 800U);
    EXPECT_GT(back, 800U);
}

TEST(MergeViews, BrightnessIsThatOfTheTexture) {
    const SolidPart part = plate(0.004);
    const Views views = views_of(part, 6, 0.02, {});
    const Cloud merged = merge_views(views.posed(), {1e-3, 2}, for_each_in_order);
    const Pose T = part_turned(cell_axis(), 0.0).inverse();
    double squares = 0.0;
    for (std::size_t i = 0; i < merged.size(); ++i) {
        squares +=
            std::pow(merged.intensity[i] - part.texture(T * merged.points[i].cast<double>()), 2);
    }
    // Smoothing over 1.5 mm of waves of 5 mm and more costs a part of the contrast of 20 levels.
    EXPECT_LT(std::sqrt(squares / static_cast<double>(merged.size())), 10.0);
}

}  // namespace
}  // namespace gripscan
