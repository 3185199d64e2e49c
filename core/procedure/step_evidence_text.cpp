#include "core/procedure/step_evidence_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/registration/turn_check.h"
#include "core/procedure/angle_pattern.h"
#include "core/registration/quality.h"

namespace gripscan {
namespace {

struct Line {
    double excess = 0.0;  ///< 1: on the limit
    std::string text;
};

std::vector<Line> lines_of(const TurnStep& row, const TurnLimits& limits) {
    std::vector<Line> lines;
    if (row.error_rad) {
        const double limit_rad = angle_limit_rad(row, limits);
        lines.push_back({std::abs(*row.error_rad) / limit_rad,
                         fmt::format("angle error {:+.3f} deg, limit {:.3f} deg",
                                     deg_from_rad(*row.error_rad), deg_from_rad(limit_rad))});
    }
    if (row.overlap && limits.overlap > 0.0) {
        lines.push_back({limits.overlap / std::max(*row.overlap, 1e-3),
                         fmt::format("overlap {:.0f} %, least {:.0f} %", 100.0 * *row.overlap,
                                     100.0 * limits.overlap)});
    }
    if (row.slip_m) {
        lines.push_back({std::abs(*row.slip_m) / limits.slip_m,
                         fmt::format("slip {:+.2f} mm along the axis, limit {:.2f} mm",
                                     kMmPerM * *row.slip_m, kMmPerM * limits.slip_m)});
    }
    if (row.tilt_rad) {
        lines.push_back({*row.tilt_rad / limits.tilt_rad,
                         fmt::format("axis tilted by {:.2f} deg, limit {:.2f} deg",
                                     deg_from_rad(*row.tilt_rad), deg_from_rad(limits.tilt_rad))});
    }
    if (row.observability) {
        lines.push_back({kLeastObservability / std::max(*row.observability, 1e-3),
                         fmt::format("observability of the turn {:.2f}, least {:.2f}",
                                     *row.observability, kLeastObservability)});
    }
    return lines;
}

}  // namespace

std::vector<std::string> evidence_of(const JudgedStep& step, const TurnLimits& limits) {
    std::vector<std::string> texts;
    if (step.foreign) texts.push_back(description(*step.foreign));
    if (!step.evidence.empty()) {
        texts.insert(texts.end(), step.evidence.begin(), step.evidence.end());
        return texts;
    }
    std::vector<Line> lines = lines_of(step.row, limits);
    std::stable_sort(lines.begin(), lines.end(),
                     [](const Line& a, const Line& b) { return a.excess > b.excess; });
    for (Line& line : lines) texts.push_back(std::move(line.text));
    return texts;
}

std::string description(const ForeignObject& object) {
    const Eigen::Vector3d centre_mm = kMmPerM * object.centre_m;
    return fmt::format(
        "something of {:.0f} mm² at ({:.0f}, {:.0f}, {:.0f}) mm that the view "
        "before does not show",
        object.area_mm2, centre_mm.x(), centre_mm.y(), centre_mm.z());
}

}  // namespace gripscan
