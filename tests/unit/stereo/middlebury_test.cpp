// Three photographed scenes with known disparities, against OpenCV's semi-global matching run
// beside it with the settings its users know.
#include "tests/unit/stereo/middlebury.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "core/stereo/stereo_cloud.h"
#include "tests/support/test_data.h"

namespace gripscan::test {
namespace {

struct Score {
    double wrong = 0.0;      ///< share off by more than 1 px; missing ones are wrong
    double median_px = 0.0;  ///< error of those there are
};

Score score(const cv::Mat& disparity, const cv::Mat1f& truth) {
    std::vector<double> errors;
    double known = 0.0, wrong = 0.0;
    for (int y = 0; y < truth.rows; ++y) {
        for (int x = 0; x < truth.cols; ++x) {
            if (!std::isfinite(truth(y, x)) || truth(y, x) <= 0.0F) continue;
            known += 1.0;
            const double d = static_cast<double>(disparity.at<float>(y, x));
            const double error = std::abs(d - static_cast<double>(truth(y, x)));
            if (!(error <= 1.0)) wrong += 1.0;
            if (std::isfinite(d)) errors.push_back(error);
        }
    }
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return {wrong / known, *middle};
}

cv::Mat sgbm(const MiddleburyScene& scene) {
    const auto matcher = cv::StereoSGBM::create(0, scene.disparities, 5, 8 * 25, 32 * 25, 1, 0, 10,
                                                100, 2, cv::StereoSGBM::MODE_SGBM_3WAY);
    cv::Mat sixteenths, disparity;
    matcher->compute(scene.frame.left, scene.frame.right, sixteenths);
    sixteenths.convertTo(disparity, CV_32F, 1.0 / 16.0);
    disparity.setTo(cv::Scalar(std::numeric_limits<float>::infinity()), sixteenths < 0);
    return disparity;
}

class Middlebury : public testing::TestWithParam<const char*> {};

TEST_P(Middlebury, IsNoWorseThanSemiGlobalMatching) {
    GRIPSCAN_TEST_DATA(folder, "middlebury-v3q");
    const MiddleburyScene scene = read_middlebury(folder / GetParam());
    StereoSettings settings;
    settings.min_disparity = 0;
    settings.num_disparities = scene.disparities;
    const auto ours =
        stereo_cloud(scene.frame, scene.rig, std::nullopt, settings, Progress{}, for_each_in_order);
    ASSERT_TRUE(ours) << ours.error().message;
    const Score mine = score(ours->disparity, scene.truth);
    const Score theirs = score(sgbm(scene), scene.truth);
    RecordProperty("wrong_percent", std::to_string(100.0 * mine.wrong));
    RecordProperty("sgbm_wrong_percent", std::to_string(100.0 * theirs.wrong));
    RecordProperty("median_px", std::to_string(mine.median_px));
    RecordProperty("sgbm_median_px", std::to_string(theirs.median_px));
    std::cout << GetParam() << ": wrong " << 100.0 * mine.wrong << " % (SGBM "
              << 100.0 * theirs.wrong << " %), median " << mine.median_px << " px (SGBM "
              << theirs.median_px << " px)\n";
    EXPECT_LT(mine.wrong, theirs.wrong);
    EXPECT_LT(mine.median_px, theirs.median_px);
}

/// The cloud promises less than the dense disparity, and keeps it.
TEST_P(Middlebury, CloudIsStricterThanTheDenseDisparity) {
    GRIPSCAN_TEST_DATA(folder, "middlebury-v3q");
    const MiddleburyScene scene = read_middlebury(folder / GetParam());
    StereoSettings settings;
    settings.min_disparity = 0;
    settings.num_disparities = scene.disparities;
    const auto ours =
        stereo_cloud(scene.frame, scene.rig, std::nullopt, settings, Progress{}, for_each_in_order);
    ASSERT_TRUE(ours) << ours.error().message;
    double known = 0.0, wrong = 0.0;
    for (std::size_t i = 0; i < ours->cloud.size(); ++i) {
        const int cell = ours->cloud.cell[i];
        const double truth = static_cast<double>(
            scene.truth(cell / scene.rig.image.width, cell % scene.rig.image.width));
        if (!std::isfinite(truth) || truth <= 0.0) continue;
        known += 1.0;
        const double z = static_cast<double>(ours->cloud.points[i].z());
        if (std::abs(scene.rig.disparity_px(z) - truth) > 1.0) wrong += 1.0;
    }
    std::cout << GetParam() << ": " << known << " points, " << 100.0 * wrong / known
              << " % wrong\n";
    EXPECT_GT(known, 0.35 * static_cast<double>(scene.truth.total()));
    EXPECT_LT(wrong / known, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Middlebury, testing::Values("Motorcycle", "Adirondack", "Teddy"));

}  // namespace
}  // namespace gripscan::test
