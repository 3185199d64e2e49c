#include "core/stereo/photometric_fit.h"

#include <algorithm>
#include <limits>

#include "core/stereo/pixel_window.h"

namespace gripscan {
namespace {

/// Variance of the gradient that noise makes, in units of the residual's variance (white noise in
/// both images, smoothed as in refine.cpp).
constexpr float kGradientNoise = 0.6F;

/// Weighted sums of a patch, for eight pixels: w weight, g gradient, l left brightness relative to
/// the centre, r residual at the plane.
struct PatchSums {
    Lanes m{}, w{}, g{}, l{}, r{}, gg{}, gl{}, gr{}, ll{}, lr{}, rr{}, ggx{}, ggy{}, ww_gg{};
};

struct Slopes {
    Lanes x{}, y{}, steepening{};
};

Slopes slopes_at(const LocalPlanes& planes, int y, int x) {
    Slopes s;
    for (int i = 0; i < std::min(kLanes, planes.value.cols - x); ++i) {
        const auto lane = static_cast<std::size_t>(i);
        s.x[lane] = planes.slope_x.at<float>(y, x + i);
        s.y[lane] = planes.slope_y.at<float>(y, x + i);
        // Beyond a slope of ±0.6 the patch is seen too obliquely for the relation to hold.
        s.steepening[lane] = 1.0F / (1.0F - std::clamp(s.x[lane], -0.6F, 0.6F));
    }
    return s;
}

PatchSums gather(const PhotometricMaps& maps, const std::vector<WindowTap>& taps, int y, int x,
                 const Slopes& plane, const PatchSettings& settings) {
    PatchSums s;
    const float surface = 1.0F / (settings.surface_tolerance_px * settings.surface_tolerance_px);
    const float fit = 1.0F / (settings.residual_limit_levels * settings.residual_limit_levels);
    const auto at = [&](const cv::Mat& map, const WindowTap& tap) {
        return map.ptr<float>(y + maps.pad + tap.dy) + x + maps.pad + tap.dx;
    };
    const float* d0 = maps.disparity.ptr<float>(y + maps.pad) + x + maps.pad;
    const float* l0 = maps.left.ptr<float>(y + maps.pad) + x + maps.pad;
    for (const WindowTap& tap : taps) {
        const float* left = at(maps.left, tap);
        const float* gradient = at(maps.gradient, tap);
        const float* disparity = at(maps.disparity, tap);
        const float* known = at(maps.known, tap);
        const float* residual = at(maps.residual, tap);
        const float dx = static_cast<float>(tap.dx);
        const float dy = static_cast<float>(tap.dy);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float off = disparity[i] - d0[i] - plane.x[i] * dx - plane.y[i] * dy;
            const float g = gradient[i] * plane.steepening[i];
            const float r = residual[i];
            const float l = left[i] - l0[i];
            const float m = tap.weight * known[i] * tukey(off * off * surface);
            const float w = m * tukey(r * r * fit);
            const float wg = w * g;
            s.m[i] += m;
            s.w[i] += w;
            s.g[i] += wg;
            s.l[i] += w * l;
            s.r[i] += w * r;
            s.gg[i] += wg * g;
            s.gl[i] += wg * l;
            s.gr[i] += wg * r;
            s.ll[i] += w * l * l;
            s.lr[i] += w * l * r;
            s.rr[i] += w * r * r;
            s.ggx[i] += wg * g * dx;
            s.ggy[i] += wg * g * dy;
            s.ww_gg[i] += wg * wg;
        }
    }
    return s;
}

/// Eliminates offset and gain, then solves for the step.
PatchFit solve(const PatchSums& s, std::size_t i) {
    PatchFit fit;
    fit.sigma_px = fit.lever_px = std::numeric_limits<float>::max();
    if (!(s.w[i] > 1.0F)) return fit;
    const float w = s.w[i];
    const float gg = s.gg[i] - s.g[i] * s.g[i] / w;
    const float gl = s.gl[i] - s.g[i] * s.l[i] / w;
    const float gr = s.gr[i] - s.g[i] * s.r[i] / w;
    const float lr = s.lr[i] - s.l[i] * s.r[i] / w;
    const float rr = s.rr[i] - s.r[i] * s.r[i] / w;
    const float ll = s.ll[i] - s.l[i] * s.l[i] / w;
    // The gain is expected within some percent of 1; a textureless patch must not invent one.
    constexpr float kGainPrior = 400.0F;
    const float information = gg - gl * gl / (ll + kGainPrior);
    const float slope = gr - gl * lr / (ll + kGainPrior);
    fit.inliers = w / s.m[i];
    fit.contrast = std::sqrt(std::max(ll / w, 0.0F));
    if (!(information > 1e-3F)) return fit;
    const float unexplained = rr - lr * lr / (ll + kGainPrior) - slope * slope / information;
    // 8-bit images have a noise of their own of 0.4 levels even where the patch fits perfectly.
    fit.rms = std::sqrt(std::max(unexplained / w, 0.16F));
    // What the noise alone adds to the gradients is no texture.
    const float from_noise = kGradientNoise * fit.rms * fit.rms * w;
    const float texture = std::max(information - from_noise, 0.5F * information);
    fit.texture_to_noise = (information - from_noise) / from_noise;
    fit.step_px = slope / texture;
    fit.sigma_px = fit.rms * std::sqrt(s.ww_gg[i] / s.gg[i] / texture);
    fit.lever_px = std::hypot(s.ggx[i], s.ggy[i]) / s.gg[i];
    return fit;
}

}  // namespace

PhotometricMaps::PhotometricMaps(cv::Size roi, int padding) : pad(padding), size(roi) {
    for (cv::Mat* m : {&left, &gradient, &disparity, &known, &residual}) {
        *m = padded_map(cv::Mat::zeros(roi, CV_32F), pad, 0.0F);
    }
}

std::vector<PatchFit> sample_patches(const PhotometricMaps& maps, const LocalPlanes& planes,
                                     float surface_tolerance_px) {
    constexpr int kEveryRow = 4;
    const std::vector<WindowTap> taps = window_taps(maps.pad);
    const PatchSettings everything{surface_tolerance_px, 1e4F};
    std::vector<PatchFit> fits;
    for (int y = 0; y < maps.size.height; y += kEveryRow) {
        const float* known = maps.known.ptr<float>(y + maps.pad) + maps.pad;
        for (int x = 0; x + kLanes <= maps.size.width; x += 2 * kLanes) {
            if (known[x] == 0.0F) continue;
            fits.push_back(solve(gather(maps, taps, y, x, slopes_at(planes, y, x), everything), 0));
        }
    }
    return fits;
}

void fit_patches(const PhotometricMaps& maps, const LocalPlanes& planes,
                 const PatchSettings& settings, const ForEach& for_each,
                 const std::function<void(int y, int x, const PatchFit&)>& take) {
    const std::vector<WindowTap> taps = window_taps(maps.pad);
    for_each_group(maps.known, maps.pad, maps.size, for_each, [&](int y, int x) {
        const float* known = maps.known.ptr<float>(y + maps.pad) + x + maps.pad;
        const PatchSums s = gather(maps, taps, y, x, slopes_at(planes, y, x), settings);
        for (int i = 0; i < std::min(kLanes, maps.size.width - x); ++i) {
            if (known[i] > 0.0F) take(y, x + i, solve(s, static_cast<std::size_t>(i)));
        }
    });
}

}  // namespace gripscan
