#include "core/scene/cloud_pieces.h"

#include <algorithm>

namespace gripscan {
namespace {

/// Where the named points lie in the grid; −1: none of them.
std::vector<std::int32_t> grid_of(const Cloud& cloud, const std::vector<std::size_t>& among) {
    std::vector<std::int32_t> grid(
        static_cast<std::size_t>(cloud.grid_width) * static_cast<std::size_t>(cloud.grid_height),
        -1);
    for (const std::size_t i : among) {
        grid[static_cast<std::size_t>(cloud.cell[i])] = static_cast<std::int32_t>(i);
    }
    return grid;
}

/// The piece that `seed` belongs to; its points leave the grid.
std::vector<std::size_t> take_piece(const Cloud& cloud, std::vector<std::int32_t>& grid,
                                    std::size_t seed, float gap_m) {
    std::vector<std::size_t> piece{seed};
    grid[static_cast<std::size_t>(cloud.cell[seed])] = -1;
    for (std::size_t next = 0; next < piece.size(); ++next) {
        const Eigen::Vector3f& p = cloud.points[piece[next]];
        const int row = cloud.cell[piece[next]] / cloud.grid_width;
        const int column = cloud.cell[piece[next]] % cloud.grid_width;
        for (int r = std::max(0, row - 1); r <= std::min(cloud.grid_height - 1, row + 1); ++r) {
            for (int c = std::max(0, column - 1); c <= std::min(cloud.grid_width - 1, column + 1);
                 ++c) {
                std::int32_t& entry = grid[static_cast<std::size_t>(r * cloud.grid_width + c)];
                if (entry < 0) continue;
                const auto j = static_cast<std::size_t>(entry);
                if ((cloud.points[j] - p).norm() > gap_m) continue;
                piece.push_back(j);
                entry = -1;
            }
        }
    }
    return piece;
}

}  // namespace

std::vector<std::size_t> points_of_small_pieces(const Cloud& cloud,
                                                const std::vector<std::size_t>& among,
                                                std::size_t least, double gap_m) {
    std::vector<std::size_t> small;
    if (!cloud.organised()) return small;
    std::vector<std::int32_t> grid = grid_of(cloud, among);
    for (const std::size_t i : among) {
        if (grid[static_cast<std::size_t>(cloud.cell[i])] < 0) continue;
        const auto piece = take_piece(cloud, grid, i, static_cast<float>(gap_m));
        if (piece.size() < least) small.insert(small.end(), piece.begin(), piece.end());
    }
    std::sort(small.begin(), small.end());
    return small;
}

}  // namespace gripscan
