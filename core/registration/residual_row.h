// One equation of an alignment, whatever it compares: how far off it is, how it answers to a small
// motion of the source, and how much it is worth.
#pragma once

#include <vector>

#include "core/geometry/pose.h"
#include "core/registration/point_to_plane.h"

namespace gripscan {

struct ResidualRow {
    Vector6d J = Vector6d::Zero();  ///< by the motion [ω; v] about a centre, target frame
    double residual = 0.0;
    double information = 0.0;                         ///< robust weight over variance
    Eigen::Vector3f where = Eigen::Vector3f::Zero();  ///< target frame, m
};

/// The rows of point-to-plane matches.
[[nodiscard]] std::vector<ResidualRow> rows_of(const std::vector<Match>& matches,
                                               const Eigen::Vector3d& centre);

/// By how much sums over patches of the surface vary more than independent rows would: noise of
/// stereo and texture is correlated over many pixels. At least 1.
[[nodiscard]] double correlation_factor(const std::vector<ResidualRow>& rows, double patch_m);

/// Adds the rows to the sums, their worth divided by `correlation`.
void add_rows(const std::vector<ResidualRow>& rows, double correlation, NormalEquations& sums);

}  // namespace gripscan
