#include "core/recognition/seen_from.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscan {
namespace {

constexpr int kDirections = 200;
/// A surface seen at a flatter angle than this (cosine) is not counted on.
constexpr float kFlattest = 0.2F;
/// Cells of the depth buffers, in point spacings: coarse enough to have no holes.
constexpr float kCell = 1.7F;

/// The nearest point of each cell, as a far camera in direction z of the basis sees them.
class DepthBuffer {
  public:
    DepthBuffer(const OrientedPoints& part, const Eigen::Vector3f& towards, float cell_m)
        : scale_(1.0F / cell_m) {
        basis_ = Eigen::Quaternionf::FromTwoVectors(towards, Eigen::Vector3f::UnitZ())
                     .toRotationMatrix();
        low_ = Eigen::Vector2f::Constant(1e9F);
        Eigen::Vector2f high = -low_;
        for (const auto& p : part.points) {
            const Eigen::Vector2f q = (basis_ * p).head<2>();
            low_ = low_.cwiseMin(q);
            high = high.cwiseMax(q);
        }
        width_ = static_cast<int>((high.x() - low_.x()) * scale_) + 1;
        height_ = static_cast<int>((high.y() - low_.y()) * scale_) + 1;
        nearest_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                        -1e9F);
        for (const auto& p : part.points) {
            const Eigen::Vector3f q = basis_ * p;
            float& nearest = nearest_[cell(q)];
            nearest = std::max(nearest, q.z());
        }
    }

    /// How far behind the nearest point of its cell p lies, m.
    [[nodiscard]] float behind_m(const Eigen::Vector3f& p) const {
        const Eigen::Vector3f q = basis_ * p;
        return nearest_[cell(q)] - q.z();
    }

  private:
    [[nodiscard]] std::size_t cell(const Eigen::Vector3f& q) const {
        const int x = std::clamp(static_cast<int>((q.x() - low_.x()) * scale_), 0, width_ - 1);
        const int y = std::clamp(static_cast<int>((q.y() - low_.y()) * scale_), 0, height_ - 1);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    float scale_;
    Eigen::Matrix3f basis_;
    Eigen::Vector2f low_;
    int width_ = 0, height_ = 0;
    std::vector<float> nearest_;
};

/// By how much points of one surface at this angle differ in depth within a cell.
float slack_m(float cosine, float cell_m) {
    const float c = std::max(std::abs(cosine), kFlattest);
    return cell_m * (1.0F + std::sqrt(1.0F - std::min(1.0F, c * c)) / c);
}

}  // namespace

const std::vector<Eigen::Vector3f>& view_directions() {
    static const std::vector<Eigen::Vector3f> directions = [] {
        std::vector<Eigen::Vector3f> all;
        // A spiral by the golden angle covers the sphere evenly.
        const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
        for (int i = 0; i < kDirections; ++i) {
            const double z = 1.0 - (2.0 * i + 1.0) / kDirections;
            const double r = std::sqrt(1.0 - z * z);
            all.push_back(Eigen::Vector3d(r * std::cos(golden * i), r * std::sin(golden * i), z)
                              .cast<float>());
        }
        return all;
    }();
    return directions;
}

SeenFrom::SeenFrom(const OrientedPoints& points, const OrientedPoints& occluders, double spacing_m,
                   const ForEach& for_each)
    : visible_(view_directions().size()), times_seen_(points.size(), 0) {
    const float cell_m = kCell * static_cast<float>(spacing_m);
    for_each(visible_.size(), [&](std::size_t d) {
        const Eigen::Vector3f& towards = view_directions()[d];
        const DepthBuffer buffer(occluders, towards, cell_m);
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            const float cosine = points.normals[i].dot(towards);
            if (cosine < kFlattest) continue;
            if (buffer.behind_m(points.points[i]) <= slack_m(cosine, cell_m)) {
                visible_[d].push_back(i);
            }
        }
    });
    for (const auto& some : visible_) {
        for (const std::uint32_t i : some) ++times_seen_[i];
    }
}

std::span<const std::uint32_t> SeenFrom::visible(const Eigen::Vector3f& towards) const {
    const auto& directions = view_directions();
    std::size_t best = 0;
    float nearest = -2.0F;
    for (std::size_t d = 0; d < directions.size(); ++d) {
        const float cosine = directions[d].dot(towards);
        if (cosine <= nearest) continue;
        nearest = cosine;
        best = d;
    }
    return visible_[best];
}

OrientedPoints outside_of(const OrientedPoints& part, bool oriented, double spacing_m,
                          const ForEach& for_each) {
    const float cell_m = kCell * static_cast<float>(spacing_m);
    const std::size_t views = view_directions().size();
    std::vector<std::vector<std::uint32_t>> seen(views);
    for_each(views, [&](std::size_t d) {
        const Eigen::Vector3f& towards = view_directions()[d];
        const DepthBuffer buffer(part, towards, cell_m);
        for (std::uint32_t i = 0; i < part.size(); ++i) {
            const float cosine = part.normals[i].dot(towards);
            if ((oriented ? cosine : std::abs(cosine)) < kFlattest) continue;
            if (buffer.behind_m(part.points[i]) <= slack_m(cosine, cell_m)) seen[d].push_back(i);
        }
    });
    std::vector<Eigen::Vector3f> from(part.size(), Eigen::Vector3f::Zero());
    std::vector<char> visible(part.size(), 0);
    for (std::size_t d = 0; d < views; ++d) {
        for (const std::uint32_t i : seen[d]) {
            from[i] += view_directions()[d];
            visible[i] = 1;
        }
    }
    OrientedPoints outside;
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (visible[i] == 0) continue;
        const bool flip = !oriented && from[i].dot(part.normals[i]) < 0.0F;
        outside.add(part.points[i], flip ? Eigen::Vector3f(-part.normals[i]) : part.normals[i]);
    }
    return outside;
}

}  // namespace gripscan
