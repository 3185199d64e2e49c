// Shared by the tests of `align`: runs it without threads, and says from the noise alone how exact
// it can be.
#pragma once

#include <gtest/gtest.h>

#include "core/registration/align.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/synthetic_views.h"

namespace gripscan::test {

/// Fails the test where there is an error.
[[nodiscard]] inline Alignment aligned(const Cloud& source, const Cloud& target,
                                       const AlignSettings& settings = {}) {
    const auto result = align(source, target, settings, {}, for_each_in_order);
    if (!result) {
        ADD_FAILURE() << result.error().message;
        return {};
    }
    return *result;
}

/// What least squares on the shape alone can reach, from the rule of thumb
/// sigma = sqrt(2) · noise / (sqrt(N_eff) · r_eff) with N_eff = N / (4 π s²) for noise smoothed
/// over s px. Arms of r_eff: n · (a × (p − c)). Half the points serve as those that both see.
[[nodiscard]] inline double rule_of_thumb_rad(const Cloud& view, const Eigen::Vector3d& axis,
                                              const ViewSettings& settings) {
    const Eigen::Vector3d c = centroid(view);
    double arms = 0.0;
    for (std::size_t i = 0; i < view.size(); ++i) {
        const Eigen::Vector3d arm = view.points[i].cast<double>() - c;
        arms += std::pow(view.normals[i].cast<double>().dot(axis.cross(arm)), 2);
    }
    const double n = static_cast<double>(view.size());
    const double s = std::max(0.3, settings.correlation_px);
    const double independent = 0.5 * n / (4.0 * std::numbers::pi * s * s);
    return std::sqrt(2.0) * settings.noise_m / std::sqrt(independent * arms / n);
}

}  // namespace gripscan::test
