#include "core/registration/quality.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gripscan {
namespace {

/// Median of |x| for x with standard deviation 1.
constexpr double kMedianOfNormal = 0.6745;

double quantile(std::vector<double>& values, double share) {
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[static_cast<std::size_t>(k)];
}

/// Eigenvalues below this share of the largest one are a null space (sliding directions).
constexpr double kNull = 1e-6;

/// Least stiffness, as a share of the largest, that a motion beside the turn is taken to have.
constexpr double kSlack = 0.01;

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    const double smallest = kNull * solver.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd inverse = solver.eigenvalues().unaryExpr(
        [&](double value) { return value > smallest ? 1.0 / value : 0.0; });
    return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

using Cube = std::array<int, 3>;

Cube cube_of(const Eigen::Vector3f& p, double edge_m) {
    const Eigen::Array3d k = (p.cast<double>().array() / edge_m).floor();
    return {static_cast<int>(k.x()), static_cast<int>(k.y()), static_cast<int>(k.z())};
}

}  // namespace

ResidualStatistics residual_statistics(const std::vector<Match>& matches) {
    std::vector<double> size_m;
    std::vector<double> over_noise;
    double squares = 0.0;
    for (const Match& m : matches) {
        over_noise.push_back(std::abs(m.residual_m) / m.sigma_m);
        if (m.weight <= 0.0F) continue;
        size_m.push_back(std::abs(m.residual_m));
        squares += size_m.back() * size_m.back();
    }
    if (size_m.empty()) return {};
    return {std::sqrt(squares / static_cast<double>(size_m.size())), quantile(size_m, 0.5),
            quantile(size_m, 0.9), quantile(over_noise, 0.5) / kMedianOfNormal};
}

Matrix6d motion_covariance(const std::vector<ResidualRow>& rows, double patch_m) {
    std::map<Cube, Vector6d> patches;
    Matrix6d H = Matrix6d::Zero();
    for (const ResidualRow& row : rows) {
        if (row.information <= 0.0) continue;
        const Vector6d g = (row.information * row.residual) * row.J;
        H += row.information * row.J * row.J.transpose();
        const auto [place, fresh] = patches.try_emplace(cube_of(row.where, patch_m), g);
        if (!fresh) place->second += g;
    }
    const double count = static_cast<double>(patches.size());
    if (count < 8.0) return Matrix6d::Identity();  // 1 rad, 1 m: nothing is known
    Matrix6d meat = Matrix6d::Zero();
    for (const auto& [cube, g] : patches) meat += g * g.transpose();
    const Matrix6d bread = pseudo_inverse(H);
    return (count / (count - 6.0)) * bread * meat * bread;
}

double sigma_about(const Matrix6d& covariance, const Eigen::Vector3d& axis) {
    return std::sqrt(std::max(0.0, axis.dot(covariance.topLeftCorner<3, 3>() * axis)));
}

double turn_observability(const Surface& source, const Surface& target,
                          const std::vector<Match>& matches, const Pose& T_target_source,
                          const Eigen::Vector3d& axis) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double total = 0.0;
    for (const Match& m : matches) {
        centre += m.weight * m.middle.cast<double>();
        total += m.weight;
    }
    if (total <= 0.0) return 0.0;
    centre /= total;
    const Eigen::Matrix3d R = T_target_source.linear();
    Matrix6d information = Matrix6d::Zero();
    double lever_squared = 0.0;
    for (const Match& m : matches) {
        if (m.weight <= 0.0F) continue;
        const Eigen::Vector3d arm = m.middle.cast<double>() - centre;
        const auto row = [&](const Eigen::Vector3d& n) {
            Vector6d J;
            J << arm.cross(n), n;
            return J;
        };
        const Vector6d a = row(R * source.normals[m.source].cast<double>());
        const Vector6d b = row(target.normals[m.target].cast<double>());
        information += (0.5 * m.weight / total) * (a * b.transpose() + b * a.transpose());
        lever_squared += m.weight / total * arm.cross(axis).squaredNorm();
    }
    // Coordinates with the axis as the first rotation; the other five are free to give way.
    Eigen::Matrix3d basis;
    basis.col(0) = axis;
    basis.col(1) = axis.unitOrthogonal();
    basis.col(2) = axis.cross(basis.col(1));
    Matrix6d turn = Matrix6d::Zero();
    const double radius = std::sqrt(lever_squared);
    turn.topLeftCorner<3, 3>() = basis / radius;
    turn.bottomRightCorner<3, 3>() = basis;
    const Matrix6d A = turn.transpose() * information * turn;
    // A product of two noisy normals may have small negative eigenvalues; what gives way that
    // easily is bounded by the floor.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 5, 5>> others(
        A.bottomRightCorner<5, 5>());
    const double floor = kSlack * others.eigenvalues().maxCoeff();
    if (floor <= 0.0) return 0.0;
    const Eigen::Matrix<double, 5, 1> cross =
        others.eigenvectors().transpose() * A.block<5, 1>(1, 0);
    const double rest =
        A(0, 0) - (cross.array().square() / others.eigenvalues().array().max(floor)).sum();
    return std::isfinite(rest) ? std::sqrt(std::clamp(rest, 0.0, 1.0)) : 0.0;
}

}  // namespace gripscan
