#include "core/procedure/motion_plan.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace gripscan {
namespace {

constexpr double kArrived_rad = 0.03 * kRadPerDeg;

void append_pieces(std::vector<double>& way, double from_rad, double to_rad, double largest_rad) {
    const double length = std::abs(to_rad - from_rad);
    const auto pieces = std::max(1.0, std::ceil(length / largest_rad - 1e-9));
    for (double i = 1.0; i < pieces; i += 1.0) {
        way.push_back(from_rad + (to_rad - from_rad) * i / pieces);
    }
    way.push_back(to_rad);
}

}  // namespace

bool stands_at(double reading_rad, double angle_rad) {
    return std::abs(reading_rad - angle_rad) < kArrived_rad;
}

std::vector<double> way_to(double target_rad, double from_rad, const MotionLimits& limits) {
    std::vector<double> way;
    if (stands_at(from_rad, target_rad)) return way;
    double at_rad = from_rad;
    if (target_rad < from_rad) {
        at_rad = std::max(target_rad - limits.approach_rad, limits.least_joint6_rad);
        append_pieces(way, from_rad, at_rad, limits.largest_move_rad);
    }
    if (at_rad < target_rad) append_pieces(way, at_rad, target_rad, limits.largest_move_rad);
    return way;
}

}  // namespace gripscan
