#include "core/procedure/still_surface.h"

#include <algorithm>
#include <cmath>

#include "core/cloud/filters.h"
#include "core/cloud/kd_tree.h"

namespace gripscan {
namespace {

constexpr double kVoxel_m = 0.0015;
/// A point is found again when the other view has one this near: grid and noise.
constexpr float kFound_m = 0.0015F;
/// It is missing when the other view has none this near.
constexpr float kMissing_m = 0.004F;
/// Points that the turn moves by less than this cannot tell.
constexpr double kLeastMove_m = 0.004;
/// The fifth of what turned that is nearest to the arm: a wrist may reach around the flange.
constexpr double kArmsShare = 0.2;

/// Where, along the axis, the arm's share of what turned begins.
double begin_of_arms_share(const Cloud& cloud, const Axis& axis, std::vector<std::size_t> turned) {
    if (turned.empty()) return 0.0;
    std::vector<double> places;
    for (const std::size_t i : turned)
        places.push_back(axis.along_m(cloud.points[i].cast<double>()));
    const auto begin =
        places.begin() +
        static_cast<std::ptrdiff_t>((1.0 - kArmsShare) * static_cast<double>(places.size() - 1));
    std::nth_element(places.begin(), begin, places.end());
    return *begin;
}

}  // namespace

StillSurface still_surface(const Cloud& first, const Cloud& second, const Axis& axis,
                           double turn_rad) {
    const Cloud thin = thinned(first, kVoxel_m);
    const KdTree tree(second.points);
    const Pose T = turn_about(axis, turn_rad);
    std::vector<std::size_t> still;
    std::vector<std::size_t> turned;
    for (std::size_t i = 0; i < thin.size(); ++i) {
        const Eigen::Vector3d p = thin.points[i].cast<double>();
        const Eigen::Vector3d q = T * p;
        if ((q - p).norm() < kLeastMove_m) continue;
        const bool stood = tree.nearest_within(thin.points[i], kFound_m).has_value();
        const bool moved = tree.nearest_within(q.cast<float>(), kMissing_m).has_value();
        if (stood && !moved) still.push_back(i);
        if (!stood && moved) turned.push_back(i);
    }
    const double arm_m = begin_of_arms_share(thin, axis, turned);
    std::vector<std::size_t> beside;
    std::vector<std::size_t> at_arm;
    for (const std::size_t i : still) {
        const double place_m = axis.along_m(thin.points[i].cast<double>());
        (place_m > arm_m ? at_arm : beside).push_back(i);
    }
    return {select(thin, beside), select(thin, at_arm)};
}

}  // namespace gripscan
