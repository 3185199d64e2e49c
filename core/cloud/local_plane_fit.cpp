#include "core/cloud/local_plane_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace gripscan {

std::optional<PlaneFit> fit_plane(std::span<const Eigen::Vector3f> points) {
    if (points.size() < 3) return std::nullopt;
    const auto n = static_cast<double>(points.size());
    // Relative to one of the points: coordinates are large beside their spread.
    const Eigen::Vector3d origin = points[0].cast<double>();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const auto& point : points) {
        const Eigen::Vector3d p = point.cast<double>() - origin;
        mean += p;
        moment += p * p.transpose();
    }
    mean /= n;
    const Eigen::Matrix3d covariance = moment / n - mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(covariance);
    const Eigen::Vector3d spread = solver.eigenvalues();
    // A line or a point: the second spread is rounding of the largest.
    if (!(spread[1] > 1e-9 * spread[2]) || !solver.eigenvectors().allFinite()) return std::nullopt;
    const double freedom = std::max(n - 3.0, 1.0);
    return PlaneFit{solver.eigenvectors().col(0).normalized(),
                    std::max(spread[0], 0.0) * n / freedom};
}

}  // namespace gripscan
