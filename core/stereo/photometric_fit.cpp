#include "core/stereo/photometric_fit.h"

#include <algorithm>
#include <limits>

#include "core/stereo/pixel_window.h"

namespace gripscan {
namespace {

/// Weighted sums of a patch, for eight pixels: w weight, g gradient, l left brightness relative to
/// the centre, r residual at the plane.
struct PatchSums {
    Lanes m, w, g, l, r, gg, gl, gr, ll, lr, rr, ggx, ggy, ww_gg;
};

struct Slopes {
    Lanes x{}, y{}, steepening{};
};

Slopes slopes_at(const LocalPlanes& planes, int y, int x) {
    Slopes s;
    for (int i = 0; i < std::min(kLanes, planes.value.cols - x); ++i) {
        s.x[i] = planes.slope_x.at<float>(y, x + i);
        s.y[i] = planes.slope_y.at<float>(y, x + i);
        // Beyond a slope of ±0.6 the patch is seen too obliquely for the relation to hold.
        s.steepening[i] = 1.0F / (1.0F - std::clamp(s.x[i], -0.6F, 0.6F));
    }
    return s;
}

GRIPSCAN_FAST PatchSums gather(const PhotometricMaps& maps, const std::vector<WindowTap>& taps,
                               int y, int x, const Slopes& plane, const PatchSettings& settings) {
    const float surface = 1.0F / (settings.surface_tolerance_px * settings.surface_tolerance_px);
    const float fit = 1.0F / (settings.residual_limit_levels * settings.residual_limit_levels);
    const Lanes d0 = load(maps.disparity.ptr<float>(y + maps.pad) + x + maps.pad);
    const Lanes l0 = load(maps.left.ptr<float>(y + maps.pad) + x + maps.pad);
    Lanes sm{}, sw{}, sg{}, sl{}, sr{}, sgg{}, sgl{}, sgr{}, sll{}, slr{}, srr{};
    Lanes sggx{}, sggy{}, swwgg{};
    for (const WindowTap& tap : taps) {
        const int row = y + maps.pad + tap.dy;
        const int column = x + maps.pad + tap.dx;
        const float dx = static_cast<float>(tap.dx);
        const float dy = static_cast<float>(tap.dy);
        const Lanes off =
            load(maps.disparity.ptr<float>(row) + column) - d0 - plane.x * dx - plane.y * dy;
        const Lanes g = load(maps.gradient.ptr<float>(row) + column) * plane.steepening;
        const Lanes r = load(maps.residual.ptr<float>(row) + column);
        const Lanes l = load(maps.left.ptr<float>(row) + column) - l0;
        const Lanes m =
            tap.weight * load(maps.known.ptr<float>(row) + column) * tukey(off * off * surface);
        const Lanes w = m * tukey(r * r * fit);
        const Lanes wg = w * g;
        const Lanes wl = w * l;
        const Lanes wgg = wg * g;
        sm += m;
        sw += w;
        sg += wg;
        sl += wl;
        sr += w * r;
        sgg += wgg;
        sgl += wg * l;
        sgr += wg * r;
        sll += wl * l;
        slr += wl * r;
        srr += w * r * r;
        sggx += wgg * dx;
        sggy += wgg * dy;
        swwgg += wg * wg;
    }
    return {sm, sw, sg, sl, sr, sgg, sgl, sgr, sll, slr, srr, sggx, sggy, swwgg};
}

/// Eliminates offset and gain, then solves for the step.
PatchFit solve(const PatchSums& s, int i) {
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
    // The ratio of both contrasts: a regression on the noisy left one would find too little.
    fit.gain = std::sqrt(std::max(ll + 2.0F * lr + rr, 0.0F) / (ll + 1e-3F)) - 1.0F;
    fit.sigma_px = fit.rms * std::sqrt(s.ww_gg[i] / s.gg[i] / texture);
    fit.lever_px = std::hypot(s.ggx[i], s.ggy[i]) / s.gg[i];
    return fit;
}

}  // namespace

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
            if (known[i] > 0.0F) take(y, x + i, solve(s, i));
        }
    });
}

}  // namespace gripscan
