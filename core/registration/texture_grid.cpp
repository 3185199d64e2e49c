#include "core/registration/texture_grid.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace gripscan {
namespace {

/// A pinhole has to explain the grid to this rms, px.
constexpr double kPinholeError_px = 0.5;

/// Catmull–Rom weights and their derivatives for the four neighbours of a fraction t.
struct Cubic {
    std::array<float, 4> w;
    std::array<float, 4> d;
    explicit Cubic(float t) {
        const float t2 = t * t;
        const float t3 = t2 * t;
        w = {0.5F * (-t3 + 2 * t2 - t), 0.5F * (3 * t3 - 5 * t2 + 2), 0.5F * (-3 * t3 + 4 * t2 + t),
             0.5F * (t3 - t2)};
        d = {0.5F * (-3 * t2 + 4 * t - 1), 0.5F * (9 * t2 - 10 * t), 0.5F * (-9 * t2 + 8 * t + 1),
             0.5F * (3 * t2 - 2 * t)};
    }
};

}  // namespace

std::optional<TextureGrid> TextureGrid::create(const Cloud& cloud) {
    if (!cloud.organised() || cloud.intensity.empty() || !cloud.viewpoint) return std::nullopt;
    TextureGrid grid;
    grid.viewpoint_ = *cloud.viewpoint;
    if (!grid.fit_pinhole(cloud)) return std::nullopt;
    grid.cut_out(cloud);
    return grid;
}

bool TextureGrid::fit_pinhole(const Cloud& cloud) {
    // u = fx · x/z + cx and v = fy · y/z + cy, each a straight line through the points.
    Eigen::Matrix2d Au = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d Av = Eigen::Matrix2d::Zero();
    Eigen::Vector2d bu = Eigen::Vector2d::Zero();
    Eigen::Vector2d bv = Eigen::Vector2d::Zero();
    double squares = 0.0;
    const auto n = static_cast<double>(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3d p = (cloud.points[i] - viewpoint_).cast<double>();
        if (p.z() <= 0.0) return false;
        const Eigen::Vector2d x(p.x() / p.z(), 1.0);
        const Eigen::Vector2d y(p.y() / p.z(), 1.0);
        const double u = cloud.cell[i] % cloud.grid_width;
        const double v = cloud.cell[i] / cloud.grid_width;
        Au += x * x.transpose();
        Av += y * y.transpose();
        bu += u * x;
        bv += v * y;
        squares += u * u + v * v;
    }
    const Eigen::Vector2d a = Au.ldlt().solve(bu);
    const Eigen::Vector2d b = Av.ldlt().solve(bv);
    if (!a.allFinite() || !b.allFinite() || a.x() <= 0.0 || b.x() <= 0.0) return false;
    pinhole_ = {static_cast<float>(a.x()), static_cast<float>(b.x()), static_cast<float>(a.y()),
                static_cast<float>(b.y())};
    double error = 0.0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3f p = cloud.points[i] - viewpoint_;
        const float du = pinhole_.fx * p.x() / p.z() + pinhole_.cx -
                         static_cast<float>(cloud.cell[i] % cloud.grid_width);
        const float dv = pinhole_.fy * p.y() / p.z() + pinhole_.cy -
                         static_cast<float>(cloud.cell[i] / cloud.grid_width);
        error += du * du + dv * dv;
    }
    return std::sqrt(error / n) < kPinholeError_px;
}

void TextureGrid::cut_out(const Cloud& cloud) {
    int last_column = 0;
    int last_row = 0;
    first_column_ = cloud.grid_width;
    first_row_ = cloud.grid_height;
    for (const std::int32_t cell : cloud.cell) {
        first_column_ = std::min(first_column_, cell % cloud.grid_width);
        last_column = std::max(last_column, cell % cloud.grid_width);
        first_row_ = std::min(first_row_, cell / cloud.grid_width);
        last_row = std::max(last_row, cell / cloud.grid_width);
    }
    width_ = last_column - first_column_ + 1;
    height_ = last_row - first_row_ + 1;
    const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    point_.assign(cells, -1);
    brightness_.assign(cells, 0.0F);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const int column = cloud.cell[i] % cloud.grid_width - first_column_;
        const int row = cloud.cell[i] / cloud.grid_width - first_row_;
        const auto cell = static_cast<std::size_t>(row * width_ + column);
        point_[cell] = static_cast<std::int32_t>(i);
        brightness_[cell] = cloud.intensity[i];
    }
}

std::optional<TextureGrid::Sample> TextureGrid::look(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f q = p - viewpoint_;
    if (q.z() <= 0.0F) return std::nullopt;
    const float inverse = 1.0F / q.z();
    const float u = pinhole_.fx * q.x() * inverse + pinhole_.cx - static_cast<float>(first_column_);
    const float v = pinhole_.fy * q.y() * inverse + pinhole_.cy - static_cast<float>(first_row_);
    const int c = static_cast<int>(std::floor(u));
    const int r = static_cast<int>(std::floor(v));
    if (c < 1 || r < 1 || c + 2 >= width_ || r + 2 >= height_) return std::nullopt;
    const Cubic x(u - static_cast<float>(c));
    const Cubic y(v - static_cast<float>(r));
    Sample sample;
    for (int j = 0; j < 4; ++j) {
        const auto row = static_cast<std::size_t>((r + j - 1) * width_ + c - 1);
        float value = 0.0F;
        float slope = 0.0F;
        for (std::size_t i = 0; i < 4; ++i) {
            if (point_[row + i] < 0) return std::nullopt;
            value += x.w[i] * brightness_[row + i];
            slope += x.d[i] * brightness_[row + i];
        }
        const auto k = static_cast<std::size_t>(j);
        sample.value += y.w[k] * value;
        sample.by_u += y.w[k] * slope;
        sample.by_v += y.d[k] * value;
    }
    const int nearest_row = v - static_cast<float>(r) < 0.5F ? r : r + 1;
    const int nearest_column = u - static_cast<float>(c) < 0.5F ? c : c + 1;
    sample.point = point_[static_cast<std::size_t>(nearest_row * width_ + nearest_column)];
    sample.u = u;
    sample.v = v;
    return sample;
}

Eigen::Vector3f TextureGrid::gradient_at(const Eigen::Vector3f& p, float by_u, float by_v) const {
    const Eigen::Vector3f q = p - viewpoint_;
    const float gx = by_u * pinhole_.fx / q.z();
    const float gy = by_v * pinhole_.fy / q.z();
    return {gx, gy, -(gx * q.x() + gy * q.y()) / q.z()};
}

}  // namespace gripscan
