// Who is next to whom in an organised cloud, on the same surface.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/cloud/cloud.h"

namespace gripscan {

/// Refers to the cloud, which must be organised, live longer and keep its points.
class GridNeighbours {
  public:
    /// Window of 2 · radius_cells + 1 cells; neighbours further away than jump_factor times what
    /// is typical for their distance in cells lie on another surface.
    GridNeighbours(const Cloud& cloud, int radius_cells, double jump_factor);

    /// The points of the window around point i on its surface, itself among them.
    void find(std::size_t i, std::vector<Eigen::Vector3f>& found) const;

    /// A vector to one side of the surface, the same side everywhere: row direction × column
    /// direction. Zero where the grid has no neighbours.
    [[nodiscard]] Eigen::Vector3f side(std::size_t i) const;

  private:
    [[nodiscard]] std::int32_t at(int u, int v) const;
    [[nodiscard]] Eigen::Vector3f difference(int u, int v, int du, int dv) const;
    [[nodiscard]] double range(std::size_t i) const;
    [[nodiscard]] double typical_step(int du, int dv) const;

    const Cloud& cloud_;
    std::vector<std::int32_t> index_;
    int radius_;
    double jump_factor_;
    double step_u_;  ///< typical distance of neighbours in a row, in units of their range
    double step_v_;  ///< and in a column
};

}  // namespace gripscan
