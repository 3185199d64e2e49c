#include "ui/views/measuring.h"

#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "ui/theme/shown_number.h"

namespace gripscan::ui {
namespace {

std::string mm(double metres) {
    return shown_number(metres * kMmPerM, 2);
}

void add_about_axis(std::vector<MeasureLine>& lines, const std::string& name,
                    const AboutAxis& point) {
    lines.push_back({name + " radius", mm(point.radius_m), "mm"});
    lines.push_back({name + " angle", shown_number(deg_from_rad(point.angle_rad), 2), "°"});
    lines.push_back({name + " height", mm(point.height_m), "mm"});
}

}  // namespace

Measuring with_point(Measuring measuring, const Eigen::Vector3d& point_m) {
    if (measuring.points_m.size() >= 2) measuring.points_m.clear();
    measuring.points_m.push_back(point_m);
    return measuring;
}

AboutAxis about_axis(const Eigen::Vector3d& point_m, const Axis& axis) {
    const Eigen::Vector3d& d = axis.direction;
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY() - d.y() * d;
    const Eigen::Vector3d zero =
        (y.norm() > 0.1 ? y : Eigen::Vector3d(Eigen::Vector3d::UnitX() - d.x() * d)).normalized();
    const Eigen::Vector3d away = point_m - axis.nearest_to(point_m);
    return {away.norm(), std::atan2(away.dot(d.cross(zero)), away.dot(zero)),
            d.dot(point_m - axis.point_m)};
}

std::vector<MeasureLine> measure_lines(const Measuring& measuring,
                                       const std::optional<Axis>& axis) {
    std::vector<MeasureLine> lines;
    const auto& points = measuring.points_m;
    if (points.size() == 2) {
        const Eigen::Vector3d d = points[1] - points[0];
        lines.push_back({"distance", mm(d.norm()), "mm"});
        lines.push_back({"dx", mm(d.x()), "mm"});
        lines.push_back({"dy", mm(d.y()), "mm"});
        lines.push_back({"dz", mm(d.z()), "mm"});
    }
    if (!axis) return lines;
    for (std::size_t i = 0; i < points.size(); ++i) {
        add_about_axis(lines, i == 0 ? "A" : "B", about_axis(points[i], *axis));
    }
    if (points.size() == 2) {
        const double turn = std::remainder(
            about_axis(points[1], *axis).angle_rad - about_axis(points[0], *axis).angle_rad,
            2.0 * std::numbers::pi);
        lines.push_back({"A to B about J6", shown_number(deg_from_rad(turn), 2), "°"});
    }
    return lines;
}

std::string measure_hint(const Measuring& measuring) {
    switch (measuring.points_m.size()) {
        case 0:
            return "Click the first point";
        case 1:
            return "Click the second point";
        default:
            return "Click to begin anew, Esc to end";
    }
}

}  // namespace gripscan::ui
