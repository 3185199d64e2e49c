#include "core/registration/axis_estimate.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/units.h"

namespace gripscan {
namespace {

constexpr double kSmallestTurn_rad = 0.1 * kRadPerDeg;
constexpr int kReweightings = 20;

/// Cauchy weight at a robust scale of the given sizes.
std::vector<double> robust_weights(const std::vector<double>& sizes) {
    std::vector<double> sorted = sizes;
    std::sort(sorted.begin(), sorted.end());
    const double scale = std::max(1e-12, 2.0 * 1.4826 * sorted[sorted.size() / 2]);
    std::vector<double> weights;
    for (const double size : sizes) {
        weights.push_back(1.0 / (1.0 + (size / scale) * (size / scale)));
    }
    return weights;
}

struct Turn {
    Eigen::Vector3d vector;  // axis times angle
    Eigen::Matrix3d R;
    Eigen::Vector3d t;
};

}  // namespace

std::optional<AxisEstimate> estimate_axis(std::span<const Pose> steps,
                                          const Eigen::Vector3d& centre_m) {
    std::vector<Turn> turns;
    for (const Pose& step : steps) {
        const Eigen::Vector3d v = rotation_vector(step.linear());
        if (v.norm() > kSmallestTurn_rad) turns.push_back({v, step.linear(), step.translation()});
    }
    if (turns.empty()) return std::nullopt;

    // Direction: main direction of the vectors, then reweighted by what lies across it.
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Turn& turn : turns) spread += turn.vector * turn.vector.transpose();
    Eigen::Vector3d direction =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
    const auto across = [&](const Turn& turn) {
        return (turn.vector - direction * direction.dot(turn.vector)).norm();
    };
    std::vector<double> sizes(turns.size());
    std::vector<double> weights(turns.size(), 1.0);
    for (int i = 0; i < kReweightings; ++i) {
        for (std::size_t k = 0; k < turns.size(); ++k) sizes[k] = across(turns[k]);
        weights = robust_weights(sizes);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < turns.size(); ++k) {
            sum +=
                weights[k] * (direction.dot(turns[k].vector) < 0.0 ? -1.0 : 1.0) * turns[k].vector;
        }
        direction = sum.normalized();
    }
    double signed_sum = 0.0;
    for (const Turn& turn : turns) signed_sum += direction.dot(turn.vector);
    if (signed_sum < 0.0) direction = -direction;

    AxisEstimate estimate;
    estimate.axis.direction = direction;
    double square = 0.0;
    double total = 0.0;
    double pull = 0.0;
    for (std::size_t k = 0; k < turns.size(); ++k) {
        square += weights[k] * std::pow(across(turns[k]), 2) / 2.0;
        pull += weights[k] * std::abs(direction.dot(turns[k].vector));
        total += weights[k];
    }
    const double n = static_cast<double>(turns.size());
    estimate.sd_rad = std::sqrt(square / std::max(total, 1e-12)) * std::sqrt(n) /
                      std::max(pull, 1e-12) * total / std::max(n, 1.0);

    // Point: (I − R) p = t across the axis, relative to the centre for good numbers.
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    const Eigen::Matrix3d across_axis =
        Eigen::Matrix3d::Identity() - direction * direction.transpose();
    std::fill(weights.begin(), weights.end(), 1.0);
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    for (int i = 0; i < kReweightings; ++i) {
        A = direction * direction.transpose();
        Eigen::Vector3d b = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < turns.size(); ++k) {
            const Eigen::Matrix3d M = across_axis * (Eigen::Matrix3d::Identity() - turns[k].R);
            const Eigen::Vector3d rest =
                across_axis * (turns[k].R * centre_m + turns[k].t - centre_m);
            A += weights[k] * M.transpose() * M;
            b += weights[k] * M.transpose() * rest;
        }
        shift = A.ldlt().solve(b);
        for (std::size_t k = 0; k < turns.size(); ++k) {
            const Eigen::Vector3d p = centre_m + shift;
            sizes[k] = (across_axis * (turns[k].R * p + turns[k].t - p)).norm();
        }
        weights = robust_weights(sizes);
    }
    estimate.axis.point_m = centre_m + shift - direction * direction.dot(shift);
    double rest = 0.0;
    for (std::size_t k = 0; k < turns.size(); ++k) rest += weights[k] * sizes[k] * sizes[k] / 2.0;
    const double variance = rest / std::max(1e-12, total);
    const Eigen::Matrix3d covariance =
        variance * across_axis * A.inverse() * across_axis.transpose();
    estimate.sd_m = std::sqrt(std::max(0.0, covariance.trace() / 2.0));
    return estimate;
}

AxisDeviation deviation_from(const Axis& axis, const Pose& T) {
    AxisDeviation d;
    const Eigen::Vector3d v = rotation_vector(T.linear());
    const double angle = v.norm();
    const double sign = v.dot(axis.direction) < 0.0 ? -1.0 : 1.0;
    d.angle_rad = sign * angle;
    if (angle > 1e-9)
        d.tilt_rad = std::acos(std::min(1.0, std::abs(v.dot(axis.direction)) / angle));
    const Eigen::Vector3d moved = T * axis.point_m - axis.point_m;
    d.slip_m = moved.dot(axis.direction);
    const double across = (moved - d.slip_m * axis.direction).norm();
    // A turn by θ about a line at distance e moves the point by 2 e sin(θ/2).
    const double chord = 2.0 * std::sin(0.5 * angle);
    d.offset_m = chord > 1e-6 ? across / chord : across;
    return d;
}

}  // namespace gripscan
