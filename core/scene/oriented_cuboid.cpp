#include "core/scene/oriented_cuboid.h"

#include <Eigen/Eigenvalues>
#include <limits>
#include <vector>

#include "core/base/units.h"

namespace gripscan {
namespace {

constexpr int kTurns_deg = 90;  ///< a rectangle looks the same after a quarter

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void extend(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    [[nodiscard]] double length() const { return high - low; }
    [[nodiscard]] double middle() const { return 0.5 * (low + high); }
};

/// Axes with z along `direction`, turned about it.
Eigen::Matrix3d axes_along(const Eigen::Vector3d& direction, double turn_rad) {
    const Eigen::Vector3d z = direction.normalized();
    const Eigen::Vector3d side = z.unitOrthogonal();
    const Eigen::Vector3d x = Eigen::AngleAxisd(turn_rad, z) * side;
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return axes;
}

OrientedCuboid enclosing(std::span<const Eigen::Vector3f> points_m, const Eigen::Matrix3d& axes) {
    std::array<Range, 3> ranges;
    for (const Eigen::Vector3f& p : points_m) {
        const Eigen::Vector3d local = axes.transpose() * p.cast<double>();
        for (int k = 0; k < 3; ++k) ranges[static_cast<std::size_t>(k)].extend(local(k));
    }
    OrientedCuboid cuboid;
    Eigen::Vector3d middle;
    for (int k = 0; k < 3; ++k) {
        middle(k) = ranges[static_cast<std::size_t>(k)].middle();
        cuboid.half_m(k) = 0.5 * ranges[static_cast<std::size_t>(k)].length();
    }
    cuboid.T_frame_cuboid.linear() = axes;
    cuboid.T_frame_cuboid.translation() = axes * middle;
    return cuboid;
}

/// Turn about z with the smallest cross-section, the longer side along x.
double best_turn_rad(std::span<const Eigen::Vector3f> points_m, const Eigen::Vector3d& direction) {
    const Eigen::Matrix3d axes = axes_along(direction, 0.0);
    std::vector<Eigen::Vector2d> flat;
    flat.reserve(points_m.size());
    for (const Eigen::Vector3f& p : points_m) {
        flat.push_back((axes.transpose() * p.cast<double>()).head<2>());
    }
    double best_m2 = std::numeric_limits<double>::infinity();
    double best_rad = 0.0;
    for (int turn_deg = 0; turn_deg < kTurns_deg; ++turn_deg) {
        const double turn_rad = rad_from_deg(turn_deg);
        const Eigen::Vector2d u(std::cos(turn_rad), std::sin(turn_rad));
        const Eigen::Vector2d v(-u.y(), u.x());
        Range along, across;
        for (const Eigen::Vector2d& p : flat) {
            along.extend(u.dot(p));
            across.extend(v.dot(p));
        }
        const double area_m2 = along.length() * across.length();
        if (area_m2 >= best_m2) continue;
        best_m2 = area_m2;
        best_rad = turn_rad + (across.length() > along.length() ? rad_from_deg(kTurns_deg) : 0.0);
    }
    return best_rad;
}

}  // namespace

std::array<Eigen::Vector3d, 8> OrientedCuboid::corners_m() const {
    std::array<Eigen::Vector3d, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Eigen::Vector3d local = half_m;
        for (int k = 0; k < 3; ++k) {
            if ((i >> k & 1U) == 0U) local(k) = -local(k);
        }
        corners[i] = T_frame_cuboid * local;
    }
    return corners;
}

OrientedCuboid widened(const OrientedCuboid& cuboid, const FaceMargins& margins) {
    OrientedCuboid result = cuboid;
    const Eigen::Vector3d low = -cuboid.half_m - margins.low_m;
    const Eigen::Vector3d high = (cuboid.half_m + margins.high_m).cwiseMax(low);
    result.half_m = 0.5 * (high - low);
    result.T_frame_cuboid.translation() = cuboid.T_frame_cuboid * (0.5 * (high + low));
    return result;
}

OrientedCuboid moved(const OrientedCuboid& cuboid, const Pose& T_frame_own) {
    return {T_frame_own * cuboid.T_frame_cuboid, cuboid.half_m};
}

OrientedCuboid cuboid_along(std::span<const Eigen::Vector3f> points_m,
                            const Eigen::Vector3d& direction) {
    if (points_m.empty()) return {};
    return enclosing(points_m, axes_along(direction, best_turn_rad(points_m, direction)));
}

OrientedCuboid cuboid_around(std::span<const Eigen::Vector3f> points_m) {
    if (points_m.empty()) return {};
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& p : points_m) mean += p.cast<double>();
    mean /= static_cast<double>(points_m.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3f& p : points_m) {
        const Eigen::Vector3d d = p.cast<double>() - mean;
        spread += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(spread);
    OrientedCuboid best = cuboid_along(points_m, principal.eigenvectors().col(0));
    for (int k = 1; k < 3; ++k) {
        const OrientedCuboid other = cuboid_along(points_m, principal.eigenvectors().col(k));
        if (other.volume_m3() < best.volume_m3()) best = other;
    }
    return best;
}

}  // namespace gripscan
