#include "core/stereo/stillness.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/median.h"

namespace gripscan {
namespace {

constexpr int kBlock = 24;
constexpr int kFewestBlocks = 4;
/// A block has texture if its motion would be known to this, px, in its worse direction; sensor
/// noise that is taken for texture promises no better than 0.14.
constexpr double kWorstSigma_px = 0.1;
/// Smoothing before the comparison keeps this share of white noise's variance.
constexpr double kSmoothing_px = 0.7;
/// Saturated pixels stay as they are, whatever moves.
constexpr float kDarkest = 3.0F;
constexpr float kBrightest = 252.0F;

/// Sums of one block's equations: difference = −gradient · motion + offset.
struct Block {
    double n = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, xd = 0.0, yd = 0.0;
    double x = 0.0, y = 0.0, d = 0.0, dd = 0.0;

    void add(double gx, double gy, double difference) {
        n += 1.0;
        xx += gx * gx;
        xy += gx * gy;
        yy += gy * gy;
        xd += gx * difference;
        yd += gy * difference;
        x += gx;
        y += gy;
        d += difference;
        dd += difference * difference;
    }
    /// Takes the free offset out.
    void centre() {
        xx -= x * x / n;
        xy -= x * y / n;
        yy -= y * y / n;
        xd -= x * d / n;
        yd -= y * d / n;
        dd -= d * d / n;
    }
};

struct Motion {
    double squared_px2 = 0.0;
    double trace = 0.0;     ///< of the inverse information: variance of the motion for noise 1
    double variance = 0.0;  ///< of what the motion leaves, levels²
    double worst = 0.0;     ///< largest eigenvalue of the inverse
};

std::optional<Motion> motion_of(Block block) {
    if (block.n < kBlock * kBlock / 2) return std::nullopt;
    block.centre();
    const double determinant = block.xx * block.yy - block.xy * block.xy;
    if (determinant <= 1e-9 * block.n) return std::nullopt;
    const double u = -(block.yy * block.xd - block.xy * block.yd) / determinant;
    const double v = -(block.xx * block.yd - block.xy * block.xd) / determinant;
    const double mean = 0.5 * (block.xx + block.yy);
    const double spread = std::hypot(0.5 * (block.xx - block.yy), block.xy);
    Motion motion;
    motion.squared_px2 = u * u + v * v;
    motion.trace = (block.xx + block.yy) / determinant;
    motion.variance = std::max(0.0, block.dd + u * block.xd + v * block.yd) / (block.n - 3.0);
    motion.worst = 1.0 / std::max(1e-12, mean - spread);
    return motion;
}

cv::Mat smoothed(const cv::Mat& image, const cv::Rect& area) {
    cv::Mat value, smooth;
    image(area).convertTo(value, CV_32F);
    cv::GaussianBlur(value, smooth, {}, kSmoothing_px, kSmoothing_px, cv::BORDER_REFLECT);
    return smooth;
}

Block block_at(const cv::Mat& a, const cv::Mat& b, int x0, int y0) {
    Block block;
    for (int y = y0; y < y0 + kBlock; ++y) {
        for (int x = x0; x < x0 + kBlock; ++x) {
            const float value = a.at<float>(y, x);
            if (value < kDarkest || value > kBrightest) continue;
            // Gradient of both images' mean: the motion's first-order error cancels.
            const auto mean = [&](int v, int u) {
                return 0.5 * (static_cast<double>(a.at<float>(v, u)) + b.at<float>(v, u));
            };
            block.add(0.5 * (mean(y, x + 1) - mean(y, x - 1)),
                      0.5 * (mean(y + 1, x) - mean(y - 1, x)),
                      static_cast<double>(b.at<float>(y, x)) - value);
        }
    }
    return block;
}

/// Smoothing correlates the noise of neighbouring pixels: a block knows as much as with the raw
/// noise, whose variance is this many times that of the smoothed one.
double raw_over_smoothed() {
    return 4.0 * CV_PI * kSmoothing_px * kSmoothing_px;
}

}  // namespace

std::optional<Stillness> stillness(const cv::Mat& first, const cv::Mat& second,
                                   const cv::Rect& area) {
    const cv::Rect inside = area & cv::Rect(0, 0, first.cols, first.rows);
    if (first.size() != second.size() || inside.width <= kBlock + 2 ||
        inside.height <= kBlock + 2) {
        return std::nullopt;
    }
    const cv::Mat a = smoothed(first, inside);
    const cv::Mat b = smoothed(second, inside);
    std::vector<Motion> motions;
    std::vector<double> variances;
    for (int y = 1; y + kBlock < inside.height; y += kBlock) {
        for (int x = 1; x + kBlock < inside.width; x += kBlock) {
            const auto motion = motion_of(block_at(a, b, x, y));
            if (!motion) continue;
            motions.push_back(*motion);
            variances.push_back(motion->variance);
        }
    }
    if (motions.empty()) return std::nullopt;
    const double variance = raw_over_smoothed() * median_of(variances);
    std::erase_if(motions,
                  [&](const Motion& m) { return std::sqrt(variance * m.worst) > kWorstSigma_px; });
    if (static_cast<int>(motions.size()) < kFewestBlocks) return std::nullopt;
    // Mean square of the motions, each block with its worth; noise alone gives a known part of it.
    double weights = 0.0, squares = 0.0, expected = 0.0, spread = 0.0;
    for (const Motion& m : motions) {
        const double w = 1.0 / (variance * m.trace);
        weights += w;
        squares += w * m.squared_px2;
        expected += 1.0;
        spread += 2.0;  // at most: all of the noise in one direction
    }
    Stillness result;
    result.blocks = static_cast<int>(motions.size());
    result.noise_levels = std::sqrt(0.5 * variance);
    result.motion_px = std::sqrt(std::max(0.0, squares - expected) / weights);
    result.least_seen_px = std::sqrt(3.0 * std::sqrt(spread) / weights);
    return result;
}

}  // namespace gripscan
