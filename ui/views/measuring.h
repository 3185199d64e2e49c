// Two points of the scene, measured: differences, distance, and where they lie about the axis.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/axis.h"

namespace gripscan::ui {

/// The tool that measures. A third click begins anew.
struct Measuring {
    bool on = false;
    std::vector<Eigen::Vector3d> points_m;  ///< none, one or two
    friend bool operator==(const Measuring&, const Measuring&) = default;
};
[[nodiscard]] Measuring with_point(Measuring measuring, const Eigen::Vector3d& point_m);

/// A point in cylinder coordinates: zero height at the axis' own point, zero angle where the
/// world's y points away from the axis (x where the axis is along y).
struct AboutAxis {
    double radius_m = 0.0;
    double angle_rad = 0.0;  ///< −π … π, right hand about the axis
    double height_m = 0.0;   ///< along the axis
};
[[nodiscard]] AboutAxis about_axis(const Eigen::Vector3d& point_m, const Axis& axis);

/// A line of the read-out: "dx", "−12.42", "mm".
struct MeasureLine {
    std::string label;
    std::string value;
    std::string unit;
};
/// Of two points: dx, dy, dz, distance; of each point its radius, angle and height where the axis
/// is known, and of both their difference in angle.
[[nodiscard]] std::vector<MeasureLine> measure_lines(const Measuring& measuring,
                                                     const std::optional<Axis>& axis);
/// What to do next: "click the first point".
[[nodiscard]] std::string measure_hint(const Measuring& measuring);

}  // namespace gripscan::ui
