#include "core/recognition/open_border.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/seeded_random.h"

namespace gripscan {
namespace {

constexpr double kSpacing_m = 1e-3;

/// One point a square millimetre or so, as far apart as scanned points are.
void add_square(OrientedPoints& to, const Eigen::Vector3f& corner, const Eigen::Vector3f& u,
                const Eigen::Vector3f& v, SeededRandom& random) {
    const Eigen::Vector3f normal = u.cross(v).normalized();
    const auto wide = static_cast<int>(u.norm() / kSpacing_m);
    const auto high = static_cast<int>(v.norm() / kSpacing_m);
    for (int i = 0; i < wide; ++i) {
        for (int j = 0; j < high; ++j) {
            const auto a = static_cast<float>((i + 0.5 + random.uniform(-0.2, 0.2)) / wide);
            const auto b = static_cast<float>((j + 0.5 + random.uniform(-0.2, 0.2)) / high);
            to.add(corner + a * u + b * v, normal);
        }
    }
}

OrientedPoints box(const Eigen::Vector3f& size, bool with_lid) {
    SeededRandom random(3);
    OrientedPoints all;
    const Eigen::Vector3f x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    const Eigen::Vector3f o = Eigen::Vector3f::Zero();
    add_square(all, o, y, x, random);
    add_square(all, o, x, z, random);
    add_square(all, o, z, y, random);
    add_square(all, o + x, y, z, random);
    add_square(all, o + y, z, x, random);
    if (with_lid) add_square(all, o + z, x, y, random);
    return all;
}

TEST(OpenBorder, AClosedSurfaceHasNone) {
    for (const float thick_m : {0.03F, 0.004F}) {  // a block, and a plate
        const OrientedPoints part = box({0.04F, 0.03F, thick_m}, true);
        const auto border = open_border(part, kSpacing_m, for_each_in_order);
        ASSERT_EQ(border.size(), part.size());
        EXPECT_LT(100 * std::count(border.begin(), border.end(), 1), std::ssize(border)) << thick_m;
    }
}

TEST(OpenBorder, IsTheRimOfWhatWasNotSeenFurther) {
    const OrientedPoints part = box({0.04F, 0.03F, 0.03F}, false);
    const auto border = open_border(part, kSpacing_m, for_each_in_order);
    int rim = 0;
    int rim_found = 0;
    int elsewhere = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const float below_m = 0.03F - part.points[i].z();
        if (below_m < 0.8e-3F) {
            ++rim;
            rim_found += border[i];
        } else if (below_m > 2e-3F) {
            elsewhere += border[i];
        }
    }
    EXPECT_GT(rim_found, 0.9 * rim);
    EXPECT_LT(100 * elsewhere, std::ssize(border));
}

}  // namespace
}  // namespace gripscan
