#include "core/procedure/swept_room.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscan {
namespace {

/// Single points are noise, at the gripper's rim and in front of the scene.
constexpr double kRimOutliers = 0.002;
constexpr std::size_t kLeastPoints = 100;
/// Where nothing is seen to stand around.
constexpr double kFarAway_m = 10.0;
/// What stands before the tip within this is in the way as well.
constexpr double kBeforeTip_m = 0.020;

/// The value below which the share lies; the values may be reordered.
double quantile(std::vector<double>& values, double share) {
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

SweepFacts swept_room(const Cloud& gripper, const Cloud& scene, const Box& region,
                      const Axis& axis) {
    SweepFacts facts;
    facts.free_radius_m = kFarAway_m;
    if (gripper.empty()) return facts;
    std::vector<double> radii, places;
    for (const Eigen::Vector3f& p : gripper.points) {
        const Eigen::Vector3d p_m = p.cast<double>();
        radii.push_back(axis.distance_m(p_m));
        places.push_back(axis.along_m(p_m));
    }
    facts.gripper_radius_m = quantile(radii, 1.0 - kRimOutliers);
    const double tip_m = quantile(places, kRimOutliers) - kBeforeTip_m;
    const double arm_m = quantile(places, 1.0 - kRimOutliers);
    std::vector<double> around;
    for (const Eigen::Vector3f& p : scene.points) {
        const Eigen::Vector3d p_m = p.cast<double>();
        const double place_m = axis.along_m(p_m);
        if (place_m < tip_m || place_m > arm_m || region.contains(p_m)) continue;
        around.push_back(axis.distance_m(p_m));
    }
    if (around.size() <= kLeastPoints) return facts;
    const auto nearest = around.begin() + static_cast<std::ptrdiff_t>(kLeastPoints);
    std::nth_element(around.begin(), nearest, around.end());
    facts.free_radius_m = *nearest;
    return facts;
}

}  // namespace gripscan
