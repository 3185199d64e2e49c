#include "core/registration/revolution_axis.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/median.h"

namespace gripscan {
namespace {

constexpr std::size_t kPointsEach = 1500;
constexpr int kReweightings = 15;
/// Share of the largest stiffness below which a shift of the axis does not show (along a cylinder).
constexpr double kSlack = 1e-3;
/// The axis must fit so much better than the next best direction, as a ratio of mean squares.
constexpr double kPlainly = 0.25;
/// At least this share of the normals must pass it within this distance, in radii of the part,
/// and must not be parallel to it: a plane is a surface of revolution about its own normal.
constexpr double kMostPass = 0.5;
constexpr double kPasses = 0.1;
constexpr double kParallel = 0.7;

/// A normal as a line: direction and moment about the centre, lengths in radii of the part.
struct Line {
    Eigen::Vector3d direction;
    Eigen::Vector3d moment;
};

struct Lines {
    std::vector<Line> lines;
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    double radius_m = 0.0;
};

Lines lines_of(std::span<const Surface* const> surfaces) {
    Lines all;
    for (const Surface* s : surfaces) {
        all.centre_m += s->centre_m / static_cast<double>(surfaces.size());
        all.radius_m += s->radius_m / static_cast<double>(surfaces.size());
    }
    for (const Surface* s : surfaces) {
        for (const std::uint32_t i : spread_sample(*s, kPointsEach)) {
            if (s->rim[i] != 0) continue;
            const Eigen::Vector3d n = s->normals[i].cast<double>();
            const Eigen::Vector3d p = (s->points[i].cast<double>() - all.centre_m) / all.radius_m;
            all.lines.push_back({n, p.cross(n)});
        }
    }
    return all;
}

/// The complex c · m + c̄ · n = 0 that fits best, |c| = 1.
struct Complex {
    Eigen::Vector3d c;
    Eigen::Vector3d c_bar;
    double ratio = 1.0;  ///< its mean square over that of the next best direction
};

Complex fitted(const std::vector<Line>& lines, const std::vector<double>& weights) {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d B = A;
    Eigen::Matrix3d C = A;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        A += weights[i] * lines[i].moment * lines[i].moment.transpose();
        B += weights[i] * lines[i].moment * lines[i].direction.transpose();
        C += weights[i] * lines[i].direction * lines[i].direction.transpose();
    }
    // c̄ for a given c, without the directions in which a shift does not show.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> shifts(C);
    const double least = kSlack * shifts.eigenvalues()(2);
    const Eigen::Vector3d inverse = shifts.eigenvalues().unaryExpr(
        [&](double value) { return value > least ? 1.0 / value : 0.0; });
    const Eigen::Matrix3d C_inverse =
        shifts.eigenvectors() * inverse.asDiagonal() * shifts.eigenvectors().transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> best(A - B * C_inverse * B.transpose());
    Complex result;
    result.c = best.eigenvectors().col(0);
    result.c_bar = -C_inverse * B.transpose() * result.c;
    result.ratio = std::max(0.0, best.eigenvalues()(0)) / std::max(best.eigenvalues()(1), 1e-12);
    return result;
}

std::vector<double> misses(const std::vector<Line>& lines, const Complex& complex) {
    std::vector<double> sizes;
    for (const Line& line : lines) {
        sizes.push_back(std::abs(complex.c.dot(line.moment) + complex.c_bar.dot(line.direction)));
    }
    return sizes;
}

double share_that_passes(const std::vector<Line>& lines, const Complex& complex) {
    const std::vector<double> sizes = misses(lines, complex);
    double passing = 0.0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool across = std::abs(lines[i].direction.dot(complex.c)) < kParallel;
        if (across && sizes[i] < kPasses) passing += 1.0;
    }
    return passing / static_cast<double>(lines.size());
}

}  // namespace

std::optional<Axis> revolution_axis(std::span<const Surface* const> surfaces) {
    if (surfaces.empty()) return std::nullopt;
    const Lines all = lines_of(surfaces);
    if (all.lines.size() < 100) return std::nullopt;
    std::vector<double> weights(all.lines.size(), 1.0);
    Complex complex = fitted(all.lines, weights);
    for (int i = 0; i < kReweightings; ++i) {
        const std::vector<double> sizes = misses(all.lines, complex);
        const double scale = std::max(1e-6, 2.0 * 1.4826 * median_of(sizes));
        for (std::size_t k = 0; k < sizes.size(); ++k) {
            weights[k] = 1.0 / (1.0 + std::pow(sizes[k] / scale, 2));
        }
        complex = fitted(all.lines, weights);
    }
    if (complex.ratio > kPlainly || share_that_passes(all.lines, complex) < kMostPass) {
        return std::nullopt;
    }
    // The line of the complex: its pitch, the part of c̄ along c, is no revolution.
    Axis axis;
    axis.direction = complex.c;
    axis.point_m = all.centre_m + all.radius_m * complex.c.cross(complex.c_bar);
    return axis;
}

}  // namespace gripscan
