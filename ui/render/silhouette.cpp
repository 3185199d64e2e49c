#include "ui/render/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscan::ui {
namespace {

/// Cells of the view that the cloud covers, with an empty border of two.
struct Mask {
    int columns = 0;
    int rows = 0;
    std::vector<std::uint8_t> cells;
    [[nodiscard]] std::uint8_t& at(int column, int row) {
        return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)];
    }
    [[nodiscard]] bool covered(int column, int row) const {
        return column >= 0 && row >= 0 && column < columns && row < rows &&
               cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)] != 0;
    }
};
constexpr int kBorder = 2;

Mask mask_of(std::span<const Eigen::Vector3f> points_m, const Pose& T_world_cloud,
             const OrbitCamera& camera, const Viewport& viewport,
             const SilhouetteSettings& settings) {
    Mask mask;
    mask.columns = static_cast<int>(viewport.width_px / settings.cell_px) + 1 + 2 * kBorder;
    mask.rows = static_cast<int>(viewport.height_px / settings.cell_px) + 1 + 2 * kBorder;
    mask.cells.assign(static_cast<std::size_t>(mask.columns) * static_cast<std::size_t>(mask.rows),
                      0);
    const Pose T = camera.T_view_world() * T_world_cloud;
    const double focal_px = 0.5 * viewport.height_px / std::tan(0.5 * camera.fov_y_rad);
    const std::size_t stride = std::max<std::size_t>(1, points_m.size() / settings.most_points);
    for (std::size_t i = 0; i < points_m.size(); i += stride) {
        const Eigen::Vector3d p = T * points_m[i].cast<double>();
        if (p.z() <= 1e-4) continue;
        const double x = 0.5 * viewport.width_px + focal_px * p.x() / p.z();
        const double y = 0.5 * viewport.height_px + focal_px * p.y() / p.z();
        if (!(x >= 0 && y >= 0 && x < viewport.width_px && y < viewport.height_px)) continue;
        mask.at(static_cast<int>(x / settings.cell_px) + kBorder,
                static_cast<int>(y / settings.cell_px) + kBorder) = 1;
    }
    return mask;
}

/// Each cell becomes the largest (or smallest) of its neighbourhood of 3 × 3.
Mask spread(const Mask& mask, bool grow) {
    Mask result = mask;
    for (int row = 0; row < mask.rows; ++row) {
        for (int column = 0; column < mask.columns; ++column) {
            bool any = false;
            bool all = true;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const bool covered = mask.covered(column + dx, row + dy);
                    any = any || covered;
                    all = all && covered;
                }
            }
            result.at(column, row) = (grow ? any : all) ? 1 : 0;
        }
    }
    return result;
}

struct Corner {
    int x;
    int y;
    friend bool operator==(const Corner&, const Corner&) = default;
};

/// Directions along the grid: right, down, left, up.
constexpr std::array<Corner, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Is the cell to the right of the edge that leaves `at` covered, and the one to its left not?
bool is_edge(const Mask& mask, const Corner& at, int direction) {
    // Cells beside the edge: right of it, left of it, relative to the corner.
    constexpr std::array<Corner, 4> kRight{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    constexpr std::array<Corner, 4> kLeft{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
    const auto d = static_cast<std::size_t>(direction);
    return mask.covered(at.x + kRight[d].x, at.y + kRight[d].y) &&
           !mask.covered(at.x + kLeft[d].x, at.y + kLeft[d].y);
}

/// Follows the border with the covered cells at its right, until it comes back.
std::vector<Corner> traced(const Mask& mask, const Corner& start, std::vector<bool>& seen) {
    std::vector<Corner> outline;
    Corner at = start;
    int direction = 0;
    do {
        outline.push_back(at);
        if (direction == 0) {
            seen[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(mask.columns + 1) +
                 static_cast<std::size_t>(at.x)] = true;
        }
        at = {at.x + kSteps[static_cast<std::size_t>(direction)].x,
              at.y + kSteps[static_cast<std::size_t>(direction)].y};
        for (const int turn : {3, 0, 1, 2}) {  // left first: diagonal cells belong together
            const int next = (direction + turn) % 4;
            if (is_edge(mask, at, next)) {
                direction = next;
                break;
            }
        }
    } while (!(at == start && direction == 0));
    return outline;
}

/// Corners of the grid as a line in px, its steps smoothed.
std::vector<Eigen::Vector2d> smoothed(const std::vector<Corner>& outline, double cell_px) {
    const std::size_t n = outline.size();
    std::vector<Eigen::Vector2d> points(n);
    constexpr int kHalf = 3;
    for (std::size_t i = 0; i < n; ++i) {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (int k = -kHalf; k <= kHalf; ++k) {
            const Corner& c = outline[(i + n + static_cast<std::size_t>(k + kHalf) -
                                       static_cast<std::size_t>(kHalf)) %
                                      n];
            sum += Eigen::Vector2d(c.x - kBorder, c.y - kBorder);
        }
        points[i] = sum / (2 * kHalf + 1) * cell_px;
    }
    points.push_back(points.front());
    return points;
}

}  // namespace

std::vector<std::vector<Eigen::Vector2d>> silhouette(std::span<const Eigen::Vector3f> points_m,
                                                     const Pose& T_world_cloud,
                                                     const OrbitCamera& camera,
                                                     const Viewport& viewport,
                                                     const SilhouetteSettings& settings) {
    Mask mask = mask_of(points_m, T_world_cloud, camera, viewport, settings);
    mask = spread(spread(mask, true), false);
    std::vector<bool> seen(static_cast<std::size_t>(mask.columns + 1) *
                           static_cast<std::size_t>(mask.rows + 1));
    std::vector<std::vector<Eigen::Vector2d>> outlines;
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.columns; ++x) {
            const auto at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.columns + 1) +
                static_cast<std::size_t>(x);
            // An upper border of a covered cell that no outline has passed yet.
            if (seen[at] || !is_edge(mask, {x, y}, 0)) continue;
            const auto outline = traced(mask, {x, y}, seen);
            if (static_cast<double>(outline.size()) * settings.cell_px < settings.least_px)
                continue;
            outlines.push_back(smoothed(outline, settings.cell_px));
        }
    }
    return outlines;
}

}  // namespace gripscan::ui
