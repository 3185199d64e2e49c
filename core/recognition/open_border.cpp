#include "core/recognition/open_border.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/cloud/kd_tree.h"

namespace gripscan {
namespace {

constexpr double kReach = 3.0;  ///< neighbours within so many spacings
constexpr std::size_t kFewest = 6;
/// Widest empty sector of a point that is no border, rad.
constexpr double kWidestSector = 0.75 * std::numbers::pi;

bool is_border(const OrientedPoints& part, std::size_t i, const std::vector<Neighbour>& near) {
    if (near.size() < kFewest) return true;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Neighbour& n : near) mean += part.points[n.index].cast<double>();
    mean /= static_cast<double>(near.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Neighbour& n : near) {
        const Eigen::Vector3d d = part.points[n.index].cast<double>() - mean;
        covariance += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> plane(covariance);
    const Eigen::Vector3d u = plane.eigenvectors().col(2);
    const Eigen::Vector3d v = plane.eigenvectors().col(1);
    std::vector<double> angles;
    for (const Neighbour& n : near) {
        if (n.index == i) continue;
        const Eigen::Vector3d d = (part.points[n.index] - part.points[i]).cast<double>();
        angles.push_back(std::atan2(d.dot(v), d.dot(u)));
    }
    std::sort(angles.begin(), angles.end());
    double widest = angles.front() + 2.0 * std::numbers::pi - angles.back();
    for (std::size_t k = 1; k < angles.size(); ++k) {
        widest = std::max(widest, angles[k] - angles[k - 1]);
    }
    return widest > kWidestSector;
}

}  // namespace

std::vector<char> open_border(const OrientedPoints& part, double spacing_m,
                              const ForEach& for_each) {
    const KdTree tree(part.points);
    std::vector<char> border(part.size(), 0);
    constexpr std::size_t kBlock = 512;
    for_each((part.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
        std::vector<Neighbour> near;
        for (std::size_t i = block * kBlock; i < std::min(part.size(), (block + 1) * kBlock); ++i) {
            tree.all_within(part.points[i], static_cast<float>(kReach * spacing_m), near);
            border[i] = is_border(part, i, near) ? 1 : 0;
        }
    });
    return border;
}

}  // namespace gripscan
