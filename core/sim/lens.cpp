#include "core/sim/lens.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscan::sim {

Lens::Lens(const Eigen::Matrix3d& K, const std::vector<double>& D, ImageSize image)
    : K_(K), image_(image) {
    std::copy_n(D.begin(), std::min<std::size_t>(D.size(), D_.size()), D_.begin());
    grid_.reserve(static_cast<std::size_t>(image.width + 1) * (image.height + 1));
    for (int row = 0; row <= image.height; ++row) {
        for (int column = 0; column <= image.width; ++column) {
            const Eigen::Vector2d x((column - 0.5 - K(0, 2)) / K(0, 0),
                                    (row - 0.5 - K(1, 2)) / K(1, 1));
            grid_.push_back(undistorted(x).cast<float>());
        }
    }
}

Eigen::Vector2f Lens::direction_at(float u_px, float v_px) const {
    const float u = u_px + 0.5F;
    const float v = v_px + 0.5F;
    const int column = std::clamp(static_cast<int>(std::floor(u)), 0, image_.width - 1);
    const int row = std::clamp(static_cast<int>(std::floor(v)), 0, image_.height - 1);
    const float a = u - static_cast<float>(column);
    const float b = v - static_cast<float>(row);
    const std::size_t stride = static_cast<std::size_t>(image_.width) + 1;
    const Eigen::Vector2f* p = &grid_[row * stride + column];
    return (1.0F - b) * ((1.0F - a) * p[0] + a * p[1]) +
           b * ((1.0F - a) * p[stride] + a * p[stride + 1]);
}

Eigen::Vector2d Lens::project(const Eigen::Vector3d& p_m) const {
    const Eigen::Vector2d x = distorted(p_m.head<2>() / p_m.z());
    return {K_(0, 0) * x.x() + K_(0, 2), K_(1, 1) * x.y() + K_(1, 2)};
}

Eigen::Vector2d Lens::distorted(const Eigen::Vector2d& x) const {
    const auto [k1, k2, p1, p2, k3] = D_;
    const double r2 = x.squaredNorm();
    const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double xy = x.x() * x.y();
    return {x.x() * radial + 2.0 * p1 * xy + p2 * (r2 + 2.0 * x.x() * x.x()),
            x.y() * radial + p1 * (r2 + 2.0 * x.y() * x.y()) + 2.0 * p2 * xy};
}

Eigen::Vector2d Lens::undistorted(const Eigen::Vector2d& x) const {
    // Fixed point; moderate lenses gain a digit with every turn.
    Eigen::Vector2d guess = x;
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d step = x - distorted(guess);
        guess += step;
        if (step.squaredNorm() < 1e-24) break;
    }
    return guess;
}

}  // namespace gripscan::sim
