#include "core/stereo/background_shift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/median.h"

namespace gripscan {
namespace {

/// All in px of the halved image.
constexpr int kPatch = 17;
constexpr int kReach = 16;
constexpr int kSpacing = 32;
/// What turns with the gripper and its shadow reach beyond the registration area.
constexpr int kMargin = 24;
/// Contrast from which a patch can be found again in all directions: the smaller eigenvalue of its
/// structure tensor, levels² per px² (noise of 2 levels leaves about 1 after halving).
constexpr double kLeastTexture = 6.0;
/// Correlation of a patch that was found again.
constexpr float kLeastCorrelation = 0.85F;
constexpr int kFewestPatches = 12;
/// Of the image's quadrants, so many must hold patches.
constexpr int kFewestQuadrants = 2;
constexpr double kMoved_px = 0.5;

std::vector<cv::Point> centres(const cv::Mat& half, const cv::Rect& excluded) {
    constexpr int kBorder = kReach + kPatch / 2 + 1;
    const cv::Rect out(excluded.x - kMargin, excluded.y - kMargin, excluded.width + 2 * kMargin,
                       excluded.height + 2 * kMargin);
    std::vector<cv::Point> points;
    for (int y = kBorder; y < half.rows - kBorder; y += kSpacing) {
        for (int x = kBorder; x < half.cols - kBorder; x += kSpacing) {
            const cv::Rect patch(x - kPatch / 2, y - kPatch / 2, kPatch, kPatch);
            if ((patch & out).empty()) points.emplace_back(x, y);
        }
    }
    return points;
}

/// Texture in the direction that has least of it.
double texture_of(const cv::Mat& patch) {
    double xx = 0.0, yy = 0.0, xy = 0.0;
    for (int y = 1; y + 1 < patch.rows; ++y) {
        for (int x = 1; x + 1 < patch.cols; ++x) {
            const double gx = 0.5 * (patch.at<uchar>(y, x + 1) - patch.at<uchar>(y, x - 1));
            const double gy = 0.5 * (patch.at<uchar>(y + 1, x) - patch.at<uchar>(y - 1, x));
            xx += gx * gx;
            yy += gy * gy;
            xy += gx * gy;
        }
    }
    const double n = (patch.rows - 2) * (patch.cols - 2);
    return (0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy)) / n;
}

/// Peak of a parabola through three values, from the middle one.
double peak(float before, float at, float after) {
    const double curvature = static_cast<double>(before) - 2.0 * at + after;
    return curvature < 0.0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0.0;
}

/// Shift of one patch, px of the halved image; nothing if it is not found again.
std::optional<cv::Point2d> shift_of(const cv::Mat& before, const cv::Mat& now, cv::Point centre) {
    const cv::Mat patch =
        before(cv::Rect(centre.x - kPatch / 2, centre.y - kPatch / 2, kPatch, kPatch));
    if (texture_of(patch) < kLeastTexture) return std::nullopt;
    constexpr int kSide = kPatch + 2 * kReach;
    const cv::Mat around = now(cv::Rect(centre.x - kSide / 2, centre.y - kSide / 2, kSide, kSide));
    cv::Mat1f score;
    cv::matchTemplate(around, patch, score, cv::TM_CCOEFF_NORMED);
    cv::Point best;
    double value = 0.0;
    cv::minMaxLoc(score, nullptr, &value, nullptr, &best);
    if (value < static_cast<double>(kLeastCorrelation) || best.x == 0 || best.y == 0 ||
        best.x + 1 == score.cols || best.y + 1 == score.rows) {
        return std::nullopt;
    }
    return cv::Point2d(
        best.x - kReach + peak(score(best.y, best.x - 1), score(best), score(best.y, best.x + 1)),
        best.y - kReach + peak(score(best.y - 1, best.x), score(best), score(best.y + 1, best.x)));
}

}  // namespace

Background background_of(const cv::Mat& left, const cv::Rect& area) {
    Background background;
    cv::resize(left, background.half, {}, 0.5, 0.5, cv::INTER_AREA);
    background.excluded = {area.x / 2, area.y / 2, (area.width + 1) / 2, (area.height + 1) / 2};
    return background;
}

std::optional<BackgroundShift> background_shift(const Background& before, const Background& now) {
    if (before.half.empty() || before.half.size() != now.half.size()) return std::nullopt;
    std::vector<double> lengths;
    std::vector<double> apart;
    std::optional<cv::Point2d> last;
    std::array<bool, 4> quadrants{};
    for (const cv::Point& centre : centres(before.half, before.excluded | now.excluded)) {
        const auto shift = shift_of(before.half, now.half, centre);
        if (!shift) continue;
        lengths.push_back(2.0 * std::hypot(shift->x, shift->y));
        if (last) apart.push_back(2.0 * std::hypot(shift->x - last->x, shift->y - last->y));
        last = shift;
        const bool right = 2 * centre.x > before.half.cols;
        const bool low = 2 * centre.y > before.half.rows;
        quadrants[(right ? 1U : 0U) + (low ? 2U : 0U)] = true;
    }
    if (static_cast<int>(lengths.size()) < kFewestPatches ||
        std::count(quadrants.begin(), quadrants.end(), true) < kFewestQuadrants) {
        return std::nullopt;
    }
    BackgroundShift result;
    result.patches = static_cast<int>(lengths.size());
    // Two neighbours carry the noise of both.
    result.noise_px = median_of(apart) / std::numbers::sqrt2;
    const double length = median_of(lengths);
    result.shift_px = std::sqrt(std::max(0.0, length * length - result.noise_px * result.noise_px));
    const bool moved = result.shift_px > kMoved_px;
    const auto agreeing = std::count_if(lengths.begin(), lengths.end(),
                                        [&](double one) { return (one > kMoved_px) == moved; });
    result.agreeing = static_cast<double>(agreeing) / static_cast<double>(lengths.size());
    return result;
}

}  // namespace gripscan
