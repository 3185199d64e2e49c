// The predicted standard deviation is worth its name: over many seeds the errors divided by it
// scatter by about one.
#include <gtest/gtest.h>

#include "tests/unit/registration/align_case.h"

namespace gripscan {
namespace {

using namespace test;

struct Ratio {
    double angle = 0.0;  ///< rms of error/sigma of the angle
    double pose = 0.0;   ///< rms of error/sigma of one of the six unknowns
};

Ratio error_over_sigma(const ViewSettings& settings, double texture_contrast) {
    constexpr int kSeeds = 20;
    double angle = 0.0;
    double pose = 0.0;
    int accepted = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const double from_rad = 0.3 * static_cast<double>(seed);
        const double turn_rad = rad_from_deg(10.0);
        const ViewPair pair =
            pair_of_views(asymmetric_part(100 + seed, texture_contrast), cell_axis(), from_rad,
                          from_rad + turn_rad, seed, settings);
        const Alignment a = aligned(pair.source, pair.target);
        if (a.verdict != Verdict::kAccept) continue;  // says itself that it is not to be trusted
        ++accepted;
        angle += std::pow((a.angle_rad - turn_rad) / a.sigma_angle_rad, 2);
        const Pose off = a.T_target_source * pair.T_target_source.inverse();
        Vector6d motion;
        motion << rotation_vector(off.linear()), off * a.centre_m - a.centre_m;
        const Vector6d sigma = a.covariance.diagonal().cwiseSqrt();
        pose += motion.cwiseQuotient(sigma).squaredNorm() / 6.0;
    }
    EXPECT_GE(accepted, kSeeds - 2);
    return {std::sqrt(angle / accepted), std::sqrt(pose / accepted)};
}

/// 20 seeds tell a ratio to 1/sqrt(40) = 16 %. Above 2 the sigma would be a lie, below 0.3 useless.
TEST(PredictedSigma, IsFairWithTexture) {
    const Ratio ratio = error_over_sigma({}, 25.0);
    std::cout << "rms error/sigma: angle " << ratio.angle << ", pose " << ratio.pose << '\n';
    EXPECT_GT(ratio.angle, 0.3);
    EXPECT_LT(ratio.angle, 2.0);
    EXPECT_GT(ratio.pose, 0.3);
    EXPECT_LT(ratio.pose, 2.5);  // the covariance leaves out what does not average out
}

/// Shape alone says nothing of the shift along the faces of this part but what noise in the normals
/// pretends, so only the angle is asked for.
TEST(PredictedSigma, IsFairForTheAngleFromShapeAlone) {
    const Ratio ratio = error_over_sigma({}, 0.0);
    std::cout << "rms error/sigma: angle " << ratio.angle << '\n';
    EXPECT_GT(ratio.angle, 0.3);
    EXPECT_LT(ratio.angle, 2.0);
}

TEST(PredictedSigma, FollowsTheNoise) {
    ViewSettings noisy;
    noisy.noise_m = 0.8e-3;
    const auto sigma_with = [](const ViewSettings& settings) {
        const ViewPair pair =
            pair_of_views(asymmetric_part(7, 0.0), cell_axis(), 0.0, 0.2, 7, settings);
        const Alignment a = aligned(pair.source, pair.target);
        return std::sqrt(a.axis.dot(a.covariance.topLeftCorner<3, 3>() * a.axis));
    };
    // Four times the noise: four times the sigma, less what sampling adds to the small one.
    const double ratio = sigma_with(noisy) / sigma_with({});
    EXPECT_GT(ratio, 1.5);
    EXPECT_LT(ratio, 6.0);
}

}  // namespace
}  // namespace gripscan
