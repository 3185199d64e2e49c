#include "core/stereo/local_plane.h"

#include <algorithm>
#include <cmath>

#include "core/stereo/match.h"
#include "core/stereo/pixel_window.h"

namespace gripscan {
namespace {

/// Weighted sums of a plane fit, for eight pixels.
struct PlaneSums {
    Lanes w, x, y, xx, xy, yy, d, xd, yd, dd;
};

/// The plane relative to the centre pixel, for eight pixels.
struct PlaneLanes {
    Lanes value{}, slope_x{}, slope_y{}, support{}, variance{};
};

struct PaddedDisparity {
    cv::Mat value;  ///< 0 where unknown
    cv::Mat known;  ///< 1 or 0
    int pad;

    PaddedDisparity(const cv::Mat& disparity, int padding) : pad(padding) {
        cv::Mat zeroed(disparity.size(), CV_32F);
        cv::Mat flag(disparity.size(), CV_32F);
        for (int y = 0; y < disparity.rows; ++y) {
            for (int x = 0; x < disparity.cols; ++x) {
                const float d = disparity.at<float>(y, x);
                const bool finite = std::isfinite(d);
                zeroed.at<float>(y, x) = finite ? d : 0.0F;
                flag.at<float>(y, x) = finite ? 1.0F : 0.0F;
            }
        }
        value = padded_map(zeroed, pad, 0.0F);
        known = padded_map(flag, pad, 0.0F);
    }
};

GRIPSCAN_FAST PlaneSums gather(const PaddedDisparity& map, const std::vector<WindowTap>& taps,
                               int y, int x, const PlaneLanes& plane, float tolerance_px) {
    const float scale = 1.0F / (tolerance_px * tolerance_px);
    const Lanes centre = load(map.value.ptr<float>(y + map.pad) + x + map.pad);
    Lanes sw{}, sx{}, sy{}, sxx{}, sxy{}, syy{}, sd{}, sxd{}, syd{}, sdd{};
    for (const WindowTap& tap : taps) {
        const int column = x + map.pad + tap.dx;
        const float dx = static_cast<float>(tap.dx);
        const float dy = static_cast<float>(tap.dy);
        const Lanes d = load(map.value.ptr<float>(y + map.pad + tap.dy) + column) - centre;
        const Lanes known = load(map.known.ptr<float>(y + map.pad + tap.dy) + column);
        const Lanes off = d - plane.value - plane.slope_x * dx - plane.slope_y * dy;
        const Lanes w = tap.weight * known * tukey(off * off * scale);
        const Lanes wd = w * d;
        sw += w;
        sx += w * dx;
        sy += w * dy;
        sxx += w * (dx * dx);
        sxy += w * (dx * dy);
        syy += w * (dy * dy);
        sd += wd;
        sxd += wd * dx;
        syd += wd * dy;
        sdd += wd * d;
    }
    return {sw, sx, sy, sxx, sxy, syy, sd, sxd, syd, sdd};
}

void solve(const PlaneSums& s, PlaneLanes& plane) {
    // Slopes of windows that hold hardly more than a line are held near zero.
    constexpr float kRidge = 4.0F;
    const Lanes w = s.w + 1e-6F;
    const Lanes mx = s.x / w;
    const Lanes my = s.y / w;
    const Lanes md = s.d / w;
    const Lanes xx = s.xx - mx * s.x + kRidge;
    const Lanes yy = s.yy - my * s.y + kRidge;
    const Lanes xy = s.xy - mx * s.y;
    const Lanes xd = s.xd - mx * s.d;
    const Lanes yd = s.yd - my * s.d;
    const Lanes det = xx * yy - xy * xy;
    plane.slope_x = (yy * xd - xy * yd) / det;
    plane.slope_y = (xx * yd - xy * xd) / det;
    plane.value = md - plane.slope_x * mx - plane.slope_y * my;
    plane.support = s.w;
    const Lanes dd = s.dd - md * s.d;
    plane.variance = (dd - plane.slope_x * xd - plane.slope_y * yd) / w;
}

/// Variance about the plane below which a pixel's own window is good enough, px².
constexpr float kFitsWell_px2 = 0.001F;
/// Another window's plane is preferred if its variance is below this share of the own one …
constexpr float kMuchBetter = 0.5F;
/// … and if it passes the pixel this closely.
constexpr float kAgrees_px = 0.6F;
/// How far away the other windows lie, in radii of the window.
constexpr float kReach = 0.75F;

/// The planes of all windows and their variances.
struct Windows {
    LocalPlanes planes;
    cv::Mat variance;
};

/// A window across a small step holds a ramp that fits neither side. Where the plane of a window
/// beside the pixel fits its own surroundings much better and agrees with the pixel, the pixel
/// belongs to that plane (the idea of Kuwahara et al. 1976, for planes).
void choose_plane(const cv::Mat& disparity, const Windows& windows, int reach_px, int y, int x,
                  LocalPlanes& chosen) {
    const LocalPlanes& own = windows.planes;
    const float d = disparity.at<float>(y, x);
    const float variance = windows.variance.at<float>(y, x);
    if (!std::isfinite(d) || variance < kFitsWell_px2) return;
    float best = kMuchBetter * variance;
    for (int dy = -reach_px; dy <= reach_px; dy += reach_px) {
        for (int dx = -reach_px; dx <= reach_px; dx += reach_px) {
            const int v = y + dy;
            const int u = x + dx;
            if (u < 0 || v < 0 || u >= disparity.cols || v >= disparity.rows) continue;
            const float there = own.value.at<float>(v, u);
            if (!std::isfinite(there) || windows.variance.at<float>(v, u) >= best) continue;
            const float slope_x = own.slope_x.at<float>(v, u);
            const float slope_y = own.slope_y.at<float>(v, u);
            const float here =
                there - slope_x * static_cast<float>(dx) - slope_y * static_cast<float>(dy);
            if (std::abs(here - d) > kAgrees_px) continue;
            best = windows.variance.at<float>(v, u);
            chosen.value.at<float>(y, x) = here;
            chosen.slope_x.at<float>(y, x) = slope_x;
            chosen.slope_y.at<float>(y, x) = slope_y;
        }
    }
}

LocalPlanes prefer_better_planes(const cv::Mat& disparity, const Windows& windows, int radius,
                                 const ForEach& for_each) {
    const LocalPlanes& own = windows.planes;
    LocalPlanes chosen{own.value.clone(), own.slope_x.clone(), own.slope_y.clone(), own.support};
    const int reach_px =
        std::max(1, static_cast<int>(std::lround(kReach * static_cast<float>(radius))));
    for_each(static_cast<std::size_t>(disparity.rows), [&](std::size_t row) {
        for (int x = 0; x < disparity.cols; ++x) {
            choose_plane(disparity, windows, reach_px, static_cast<int>(row), x, chosen);
        }
    });
    return chosen;
}

}  // namespace

LocalPlanes fit_local_planes(const cv::Mat& disparity, const PlaneSettings& settings,
                             const ForEach& for_each) {
    const PaddedDisparity map(disparity, settings.radius);
    const std::vector<WindowTap> taps = window_taps(settings.radius);
    Windows windows;
    LocalPlanes& planes = windows.planes;
    for (cv::Mat* m : {&planes.slope_x, &planes.slope_y, &planes.support}) {
        *m = cv::Mat::zeros(disparity.size(), CV_32F);
    }
    planes.value = cv::Mat(disparity.size(), CV_32F, cv::Scalar(kNoDisparity));
    windows.variance = cv::Mat::zeros(disparity.size(), CV_32F);
    for_each_group(map.known, map.pad, disparity.size(), for_each, [&](int y, int x) {
        PlaneLanes plane;
        float tolerance = settings.tolerance_px;
        for (int round = 0; round < settings.rounds; ++round) {
            solve(gather(map, taps, y, x, plane, tolerance), plane);
            tolerance *= 0.5F;
        }
        const float* centre = map.value.ptr<float>(y + map.pad) + x + map.pad;
        const float* known = map.known.ptr<float>(y + map.pad) + x + map.pad;
        for (int i = 0; i < std::min(kLanes, disparity.cols - x); ++i) {
            if (known[i] == 0.0F) continue;
            planes.value.at<float>(y, x + i) = centre[i] + plane.value[i];
            planes.slope_x.at<float>(y, x + i) = plane.slope_x[i];
            planes.slope_y.at<float>(y, x + i) = plane.slope_y[i];
            planes.support.at<float>(y, x + i) = plane.support[i];
            windows.variance.at<float>(y, x + i) = std::max(plane.variance[i], 0.0F);
        }
    });
    if (!settings.look_beside) return planes;
    return prefer_better_planes(disparity, windows, settings.radius, for_each);
}

}  // namespace gripscan
