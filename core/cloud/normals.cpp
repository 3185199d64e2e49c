#include "core/cloud/blocks.h"
#include "core/cloud/filters.h"
#include "core/cloud/grid_neighbours.h"
#include "core/cloud/kd_tree.h"
#include "core/cloud/local_plane_fit.h"

namespace gripscan {
namespace {

void turn_towards(Eigen::Vector3f& normal, const Eigen::Vector3f& direction) {
    if (normal.dot(direction) < 0.0F) normal = -normal;
}

/// The same side of the grid everywhere; that side is away from the centroid for most points.
void orient_by_grid(Cloud& cloud, const GridNeighbours& neighbours) {
    const Eigen::Vector3f middle = centroid(cloud).cast<float>();
    std::size_t away = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3f outwards = cloud.points[i] - middle;
        const Eigen::Vector3f side = neighbours.side(i);
        turn_towards(cloud.normals[i], side.isZero() ? outwards : side);
        if (cloud.normals[i].dot(outwards) > 0.0F) ++away;
    }
    if (2 * away >= cloud.size()) return;
    for (auto& normal : cloud.normals) normal = -normal;
}

void orient_away_from(Cloud& cloud, const Eigen::Vector3f& inside) {
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        turn_towards(cloud.normals[i], cloud.points[i] - inside);
    }
}

void orient_towards(Cloud& cloud, const Eigen::Vector3f& viewpoint) {
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        turn_towards(cloud.normals[i], viewpoint - cloud.points[i]);
    }
}

/// Where there is no plane, the direction a point is seen from is the best guess.
Eigen::Vector3f viewing_direction(const Cloud& cloud, std::size_t i) {
    const Eigen::Vector3f view =
        cloud.viewpoint.value_or(Eigen::Vector3f::Zero()) - cloud.points[i];
    return view.norm() > 0.0F ? Eigen::Vector3f(view.normalized()) : Eigen::Vector3f::UnitZ();
}

/// Fits a plane to what find(i, points) names for every point.
template <typename Find>
void fit_normals(Cloud& cloud, const ForEach& for_each, Find find) {
    for_each_block(cloud.size(), for_each, [&](std::size_t begin, std::size_t end) {
        std::vector<Eigen::Vector3f> near;
        for (std::size_t i = begin; i < end; ++i) {
            find(i, near);
            const auto plane = fit_plane(near);
            if (plane) {
                cloud.normals[i] = plane->normal.cast<float>();
            } else {
                cloud.normals[i] = viewing_direction(cloud, i);
            }
        }
    });
}

void from_grid(Cloud& cloud, const NormalSettings& settings, const ForEach& for_each) {
    const GridNeighbours neighbours(cloud, settings.radius_cells, settings.jump_factor);
    fit_normals(cloud, for_each, [&](std::size_t i, auto& near) { neighbours.find(i, near); });
    if (!cloud.viewpoint) orient_by_grid(cloud, neighbours);
}

void from_tree(Cloud& cloud, const NormalSettings& settings, const ForEach& for_each) {
    const KdTree tree(cloud.points);
    fit_normals(cloud, for_each, [&](std::size_t i, auto& near) {
        thread_local std::vector<Neighbour> found;
        tree.k_nearest(cloud.points[i], static_cast<std::size_t>(settings.neighbours), found);
        near.clear();
        for (const Neighbour& n : found) near.push_back(cloud.points[n.index]);
    });
    if (!cloud.viewpoint) orient_away_from(cloud, centroid(cloud).cast<float>());
}

}  // namespace

void estimate_normals(Cloud& cloud, const NormalSettings& settings, const ForEach& for_each) {
    cloud.normals.clear();
    if (cloud.size() < 3) return;
    cloud.normals.resize(cloud.size());
    if (cloud.organised()) {
        from_grid(cloud, settings, for_each);
    } else {
        from_tree(cloud, settings, for_each);
    }
    if (cloud.viewpoint) orient_towards(cloud, *cloud.viewpoint);
}

}  // namespace gripscan
