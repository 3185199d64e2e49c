#include "core/stereo/triangulate.h"

#include <cmath>
#include <opencv2/core.hpp>

#include "core/stereo/local_plane.h"

namespace gripscan {
namespace {

constexpr int kNormalRadiusPx = 8;
/// Weight of the neighbours a normal needs (the full window has about 85).
constexpr float kMinSupport = 10.0F;
/// cos of the angle between normal and ray below which a surface is seen too obliquely (81 deg).
constexpr double kMinCosine = 0.15;

/// Normal of the plane d(u, v) = d0 + a (u − u0) + b (v − v0), towards the camera. From
/// n·X = const and X = Z·((u − cx)/f, (v − cy)/f, 1), Z = f·B/d'.
Eigen::Vector3d normal_from_slopes(const RectifiedRig& rig, double u, double v, double disparity,
                                   double a, double b) {
    const double d = disparity + rig.cx_right_px - rig.cx_left_px;
    const Eigen::Vector3d n(rig.f_px * a, rig.f_px * b,
                            d - a * (u - rig.cx_left_px) - b * (v - rig.cy_px));
    return -n.normalized();
}

}  // namespace

Cloud triangulate(const cv::Mat& disparity, const cv::Mat& sigma, const cv::Rect& roi,
                  const cv::Mat& grey, const RectifiedRig& rig, const std::optional<Box>& keep,
                  const ForEach& for_each) {
    PlaneSettings plane_settings;
    plane_settings.radius = kNormalRadiusPx;
    plane_settings.tolerance_px = 1.0F;
    const LocalPlanes planes = fit_local_planes(disparity, plane_settings, for_each);
    Cloud cloud;
    cloud.grid_width = rig.image.width;
    cloud.grid_height = rig.image.height;
    cloud.viewpoint = Eigen::Vector3f::Zero();
    for (int y = 0; y < roi.height; ++y) {
        for (int x = 0; x < roi.width; ++x) {
            const double d = static_cast<double>(disparity.at<float>(y, x));
            // Half a pixel from infinity the depth is only a guess.
            if (!std::isfinite(d) || d + rig.cx_right_px - rig.cx_left_px < 0.5) continue;
            if (planes.support.at<float>(y, x) < kMinSupport) continue;
            const double u = roi.x + x;
            const double v = roi.y + y;
            const Eigen::Vector3d p = rig.point_m(u, v, d);
            if (keep && !keep->contains(p)) continue;
            const Eigen::Vector3d n = normal_from_slopes(
                rig, u, v, d, static_cast<double>(planes.slope_x.at<float>(y, x)),
                static_cast<double>(planes.slope_y.at<float>(y, x)));
            const Eigen::Vector3d ray = p.normalized();
            if (-n.dot(ray) < kMinCosine) continue;
            const double along_ray = p.norm() * p.z() / (rig.f_px * rig.baseline_m);
            cloud.points.push_back(p.cast<float>());
            cloud.normals.push_back(n.cast<float>());
            cloud.intensity.push_back(static_cast<float>(grey.at<uchar>(roi.y + y, roi.x + x)));
            cloud.sigma.push_back(
                static_cast<float>(along_ray * static_cast<double>(sigma.at<float>(y, x))));
            cloud.cell.push_back((roi.y + y) * rig.image.width + roi.x + x);
        }
    }
    return cloud;
}

}  // namespace gripscan
