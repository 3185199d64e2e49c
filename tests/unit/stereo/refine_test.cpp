// The sub-pixel refinement against surfaces whose disparity is known exactly: random error, pixel
// locking, curvature, differences of exposure, and whether the predicted sigma is honest.
#include "core/stereo/refine.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/stereo/match.h"
#include "tests/unit/stereo/ray_scene.h"

namespace gripscan::test {
namespace {

constexpr int kBins = 8;
constexpr int kBorderPx = 20;  ///< patches there hang over the image

struct Errors {
    double rms_px = 0.0;
    double mean_px = 0.0;
    double locking_px = 0.0;  ///< half the span of the mean error over the fraction of a pixel
    double chi = 0.0;         ///< rms of error over predicted sigma
    double filled = 0.0;
    double gross = 0.0;  ///< share off by more than half a pixel
};

struct Case {
    RenderedPair pair;
    RectifiedRig rig;
    SearchArea area;
    cv::Mat guess;
    Refined refined;
};

/// A small image whose cameras are shifted so that both see the same part, 0.65 … 0.95 m away.
RectifiedRig near_rig() {
    RectifiedRig rig = cell_rig(320, 240);
    rig.cx_right_px = rig.cx_left_px + 140.0;
    return rig;
}

Case run(const RayScene& scene, const CameraNoise& noise = {}) {
    Case c;
    c.rig = near_rig();
    c.pair = render(scene, c.rig, noise);
    StereoSettings settings;
    settings.min_disparity = -18;
    settings.num_disparities = 64;
    c.area = *search_area(c.rig, std::nullopt, settings);
    c.guess = match(c.pair.frame, c.area);
    c.refined =
        refine_disparity(c.pair.frame, c.area.roi, c.guess, RefineSettings{}, for_each_in_order);
    return c;
}

Errors errors(const Case& c, const cv::Mat& disparity, int surface = 0) {
    Errors e;
    std::array<double, kBins> bias{};
    std::array<double, kBins> count{};
    double visible = 0.0, known = 0.0, chi = 0.0;
    for (int y = kBorderPx; y < disparity.rows - kBorderPx; ++y) {
        for (int x = kBorderPx; x < disparity.cols - kBorderPx; ++x) {
            if (c.pair.visible_in_both(y, x) == 0 || c.pair.surface(y, x) != surface) continue;
            visible += 1.0;
            if (!std::isfinite(disparity.at<float>(y, x))) continue;
            const double truth = static_cast<double>(c.pair.disparity(y, x));
            const double error = static_cast<double>(disparity.at<float>(y, x)) - truth;
            if (std::abs(error) > 0.5) {
                e.gross += 1.0;
                continue;
            }
            known += 1.0;
            e.mean_px += error;
            e.rms_px += error * error;
            const double sigma = static_cast<double>(c.refined.sigma.at<float>(y, x));
            if (std::isfinite(sigma)) chi += error * error / (sigma * sigma);
            const auto bin = static_cast<std::size_t>((truth - std::floor(truth)) * kBins) % kBins;
            bias[bin] += error;
            count[bin] += 1.0;
        }
    }
    e.mean_px /= known;
    e.rms_px = std::sqrt(e.rms_px / known);
    e.chi = std::sqrt(chi / known);
    e.filled = known / visible;
    e.gross /= visible;
    double low = 1e9, high = -1e9;
    for (std::size_t i = 0; i < kBins; ++i) {
        if (count[i] < 500.0) continue;
        low = std::min(low, bias[i] / count[i]);
        high = std::max(high, bias[i] / count[i]);
    }
    e.locking_px = 0.5 * (high - low);
    return e;
}

RayScene slanted_plane(double slant_rad, std::uint64_t seed) {
    RayScene scene;
    scene.planes.push_back(
        {Eigen::Vector3d(0.8 * std::sin(slant_rad), 0.6 * std::sin(slant_rad), std::cos(slant_rad)),
         0.76 * std::cos(slant_rad)});
    scene.seed = seed;
    return scene;
}

TEST(Refine, RemovesPixelLockingOnSlantedPlanes) {
    for (const std::uint64_t seed : {1, 2}) {
        for (const double slant : {0.25, 0.5, 0.75}) {
            const Case c = run(slanted_plane(slant, seed));
            const Errors before = errors(c, c.guess);
            const Errors after = errors(c, c.refined.disparity);
            SCOPED_TRACE(testing::Message() << "seed " << seed << " slant " << slant);
            // Noise of 2 levels on a texture of some 20: 0.05 px for a patch of 13 px.
            EXPECT_LT(after.rms_px, 0.06);
            EXPECT_LT(after.rms_px, 0.5 * before.rms_px);
            // A bin of the fraction holds some ten independent patches: 0.015 is their noise.
            EXPECT_LT(after.locking_px, 0.015);
            EXPECT_LT(after.locking_px, 0.3 * before.locking_px);
            EXPECT_LT(std::abs(after.mean_px), 0.01);
            EXPECT_GT(after.filled, 0.9);
            EXPECT_LT(after.gross, 0.02);
            // Predicted sigma against real error.
            EXPECT_GT(after.chi, 0.8);
            EXPECT_LT(after.chi, 1.25);
        }
    }
}

TEST(Refine, KeepsCurvedSurfacesInPlace) {
    RayScene scene;
    scene.planes.push_back({Eigen::Vector3d(0.0, 0.0, 1.0), 0.90});
    scene.spheres.push_back({Eigen::Vector3d(0.0, 0.0, 0.76), 0.07});
    const Case c = run(scene);
    const Errors after = errors(c, c.refined.disparity, 1);
    EXPECT_LT(after.rms_px, 0.09);
    // A plane fitted to a patch of this sphere would be off by 0.04 px.
    EXPECT_LT(std::abs(after.mean_px), 0.025);
    EXPECT_GT(after.filled, 0.85);
}

TEST(Refine, DoesNotMindDifferentExposures) {
    CameraNoise noise;
    noise.right_gain = 1.15;
    noise.right_offset = -30.0;
    const Case c = run(slanted_plane(0.4, 3), noise);
    const Errors after = errors(c, c.refined.disparity);
    EXPECT_LT(after.rms_px, 0.06);
    EXPECT_LT(after.locking_px, 0.015);
    EXPECT_GT(after.filled, 0.9);
}

TEST(Refine, GivesNothingWhereThereIsNoTexture) {
    RayScene scene = slanted_plane(0.3, 4);
    scene.contrast = 0.0;
    const Case c = run(scene);
    EXPECT_LT(errors(c, c.refined.disparity).filled, 0.01);
}

/// Two images that have nothing to do with each other.
TEST(Refine, GivesNothingForAWrongPair) {
    Case c = run(slanted_plane(0.3, 5));
    c.pair.frame.right = render(slanted_plane(0.3, 6), c.rig, {}).frame.right;
    const cv::Mat guess = match(c.pair.frame, c.area);
    const Refined refined =
        refine_disparity(c.pair.frame, c.area.roi, guess, RefineSettings{}, for_each_in_order);
    const Errors e = errors(c, refined.disparity);
    EXPECT_LT(e.filled + e.gross, 0.06);
}

}  // namespace
}  // namespace gripscan::test
