#include "core/cloud/grid_neighbours.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gripscan {

GridNeighbours::GridNeighbours(const Cloud& cloud, int radius_cells, double jump_factor)
    : cloud_(cloud),
      index_(point_of_cell(cloud)),
      radius_(radius_cells),
      jump_factor_(jump_factor),
      step_u_(typical_step(1, 0)),
      step_v_(typical_step(0, 1)) {}

std::int32_t GridNeighbours::at(int u, int v) const {
    if (u < 0 || v < 0 || u >= cloud_.grid_width || v >= cloud_.grid_height) return -1;
    return index_[static_cast<std::size_t>(v) * static_cast<std::size_t>(cloud_.grid_width) +
                  static_cast<std::size_t>(u)];
}

/// The rays of a camera spread: the step grows with the distance from it. Unknown: all the same.
double GridNeighbours::range(std::size_t i) const {
    if (!cloud_.viewpoint) return 1.0;
    return static_cast<double>((cloud_.points[i] - *cloud_.viewpoint).norm());
}

double GridNeighbours::typical_step(int du, int dv) const {
    std::vector<double> steps;
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
        const int cell = cloud_.cell[i];
        const std::int32_t j = at(cell % cloud_.grid_width + du, cell / cloud_.grid_width + dv);
        if (j < 0) continue;
        const auto& next = cloud_.points[static_cast<std::size_t>(j)];
        steps.push_back(static_cast<double>((next - cloud_.points[i]).norm()) / range(i));
    }
    if (steps.empty()) return 0.0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

void GridNeighbours::find(std::size_t i, std::vector<Eigen::Vector3f>& found) const {
    found.clear();
    const int row = cloud_.cell[i] / cloud_.grid_width;
    const int column = cloud_.cell[i] % cloud_.grid_width;
    const double jump = jump_factor_ * range(i);
    for (int dv = -radius_; dv <= radius_; ++dv) {
        for (int du = -radius_; du <= radius_; ++du) {
            const std::int32_t j = at(column + du, row + dv);
            if (j < 0) continue;
            const auto& q = cloud_.points[static_cast<std::size_t>(j)];
            const double reach_m = jump * std::hypot(du * step_u_, dv * step_v_);
            if (static_cast<double>((q - cloud_.points[i]).norm()) <= reach_m) found.push_back(q);
        }
    }
}

Eigen::Vector3f GridNeighbours::difference(int u, int v, int du, int dv) const {
    for (int reach = radius_; reach > 0; --reach) {
        const std::int32_t a = at(u - reach * du, v - reach * dv);
        const std::int32_t b = at(u + reach * du, v + reach * dv);
        if (a >= 0 && b >= 0) {
            return cloud_.points[static_cast<std::size_t>(b)] -
                   cloud_.points[static_cast<std::size_t>(a)];
        }
    }
    return Eigen::Vector3f::Zero();
}

Eigen::Vector3f GridNeighbours::side(std::size_t i) const {
    const int row = cloud_.cell[i] / cloud_.grid_width;
    const int column = cloud_.cell[i] % cloud_.grid_width;
    return difference(column, row, 1, 0).cross(difference(column, row, 0, 1));
}

}  // namespace gripscan
