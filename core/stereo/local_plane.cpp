#include "core/stereo/local_plane.h"

#include "core/stereo/match.h"
#include "core/stereo/pixel_window.h"

namespace gripscan {
namespace {

/// Weighted sums of a plane fit, for eight pixels.
struct PlaneSums {
    Lanes w{}, x{}, y{}, xx{}, xy{}, yy{}, d{}, xd{}, yd{};
};

/// The plane relative to the centre pixel, for eight pixels.
struct PlaneLanes {
    Lanes value{}, slope_x{}, slope_y{}, support{};
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

PlaneSums gather(const PaddedDisparity& map, const std::vector<WindowTap>& taps, int y, int x,
                 const PlaneLanes& plane, float tolerance_px) {
    PlaneSums s;
    const float scale = 1.0F / (tolerance_px * tolerance_px);
    const float* centre = map.value.ptr<float>(y + map.pad) + x + map.pad;
    for (const WindowTap& tap : taps) {
        const float* value = map.value.ptr<float>(y + map.pad + tap.dy) + x + map.pad + tap.dx;
        const float* known = map.known.ptr<float>(y + map.pad + tap.dy) + x + map.pad + tap.dx;
        const float dx = static_cast<float>(tap.dx);
        const float dy = static_cast<float>(tap.dy);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float d = value[i] - centre[i];
            const float off = d - plane.value[i] - plane.slope_x[i] * dx - plane.slope_y[i] * dy;
            const float w = tap.weight * known[i] * tukey(off * off * scale);
            s.w[i] += w;
            s.x[i] += w * dx;
            s.y[i] += w * dy;
            s.xx[i] += w * dx * dx;
            s.xy[i] += w * dx * dy;
            s.yy[i] += w * dy * dy;
            s.d[i] += w * d;
            s.xd[i] += w * dx * d;
            s.yd[i] += w * dy * d;
        }
    }
    return s;
}

void solve(const PlaneSums& s, PlaneLanes& plane) {
    // Slopes of windows that hold hardly more than a line are held near zero.
    constexpr float kRidge = 4.0F;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float w = std::max(s.w[i], 1e-6F);
        const float mx = s.x[i] / w;
        const float my = s.y[i] / w;
        const float md = s.d[i] / w;
        const float xx = s.xx[i] - mx * s.x[i] + kRidge;
        const float yy = s.yy[i] - my * s.y[i] + kRidge;
        const float xy = s.xy[i] - mx * s.y[i];
        const float xd = s.xd[i] - mx * s.d[i];
        const float yd = s.yd[i] - my * s.d[i];
        const float det = xx * yy - xy * xy;
        plane.slope_x[i] = (yy * xd - xy * yd) / det;
        plane.slope_y[i] = (xx * yd - xy * xd) / det;
        plane.value[i] = md - plane.slope_x[i] * mx - plane.slope_y[i] * my;
        plane.support[i] = s.w[i];
    }
}

}  // namespace

LocalPlanes fit_local_planes(const cv::Mat& disparity, const PlaneSettings& settings,
                             const ForEach& for_each) {
    const PaddedDisparity map(disparity, settings.radius);
    const std::vector<WindowTap> taps = window_taps(settings.radius);
    LocalPlanes planes;
    for (cv::Mat* m : {&planes.slope_x, &planes.slope_y, &planes.support}) {
        *m = cv::Mat::zeros(disparity.size(), CV_32F);
    }
    planes.value = cv::Mat(disparity.size(), CV_32F, cv::Scalar(kNoDisparity));
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
            const auto lane = static_cast<std::size_t>(i);
            planes.value.at<float>(y, x + i) = centre[i] + plane.value[lane];
            planes.slope_x.at<float>(y, x + i) = plane.slope_x[lane];
            planes.slope_y.at<float>(y, x + i) = plane.slope_y[lane];
            planes.support.at<float>(y, x + i) = plane.support[lane];
        }
    });
    return planes;
}

}  // namespace gripscan
