// What an alignment is worth, read from the data alone: uncertainty, observability, residuals.
#pragma once

#include <vector>

#include "core/base/units.h"
#include "core/geometry/pose.h"
#include "core/registration/residual_row.h"

namespace gripscan {

struct ResidualStatistics {
    double rms_m = 0.0;  ///< of the matches that are no outliers, along the normal
    double median_m = 0.0;
    double p90_m = 0.0;
    /// Median of all residuals, outliers too, over that predicted from the noise of their points.
    double over_noise = 0.0;
};
[[nodiscard]] ResidualStatistics residual_statistics(const std::vector<Match>& matches);

/// Covariance of [ω; v] (rad, m). Residuals of stereo data are correlated over the
/// matcher's window and over parts of the surface, so the sums are taken over patches of the
/// surface and the patches are treated as independent (the cluster-robust or "sandwich" estimate,
/// Liang and Zeger 1986); never below what independent points would give.
/// The rows' Jacobians are about the centre that the covariance shall be about.
[[nodiscard]] Matrix6d motion_covariance(const std::vector<ResidualRow>& rows, double patch_m);

/// Standard deviation of the rotation about the unit vector `axis`, rad.
[[nodiscard]] double sigma_about(const Matrix6d& covariance, const Eigen::Vector3d& axis);

/// An angle known no better than this decides nothing: three of it exceed any limit in use.
inline constexpr double kLargestSigma_rad = 2.0 * kRadPerDeg;
/// A turn whose surface resists with less than this share cannot be told from no turn.
inline constexpr double kLeastObservability = 0.08;

/// The share of the largest possible lever arm with which the surface resists a turn about `axis`
/// while everything else may give way: 0 for a surface of revolution about it, near 0.5 for a
/// cube. The normals of both surfaces enter as a product, so that their noise does not pass for
/// shape.
[[nodiscard]] double turn_observability(const Surface& source, const Surface& target,
                                        const std::vector<Match>& matches,
                                        const Pose& T_target_source, const Eigen::Vector3d& axis);

}  // namespace gripscan
