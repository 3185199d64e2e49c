#include "core/registration/view_distance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/cloud/kd_tree.h"

namespace gripscan {
namespace {

/// A view's points as the others search them.
struct Searched {
    Cloud cloud;  ///< in the frame of the first view
    KdTree tree;
};

Searched searched(const PosedView& view) {
    Cloud moved = transformed(*view.cloud, view.T_first_view);
    KdTree tree(moved.points);
    return {std::move(moved), std::move(tree)};
}

/// To the surface through the nearest point.
std::optional<float> distance(const Eigen::Vector3f& point, const Searched& other) {
    const auto near = other.tree.nearest_within(point, static_cast<float>(kFarthestSeenAgain_m));
    if (!near) return std::nullopt;
    const Eigen::Vector3f between = point - other.cloud.points[near->index];
    return std::abs(other.cloud.normals[near->index].dot(between));
}

}  // namespace

std::vector<std::vector<float>> distances_to_other_views(std::span<const PosedView> views,
                                                         std::size_t around,
                                                         const ForEach& for_each) {
    const std::size_t n = views.size();
    std::vector<std::optional<Searched>> all(n);
    for_each(n, [&](std::size_t k) { all[k].emplace(searched(views[k])); });
    std::vector<std::vector<float>> distances(n);
    for_each(n, [&](std::size_t k) {
        std::vector<float>& own = distances[k];
        own.assign(views[k].cloud->size(), kNotSeenAgain);
        for (std::size_t j = 0; j < n; ++j) {
            const std::size_t apart = j > k ? j - k : k - j;
            if (apart == 0 || std::min(apart, n - apart) > around) continue;
            for (std::size_t i = 0; i < own.size(); ++i) {
                const auto d = distance(all[k]->cloud.points[i], *all[j]);
                // The view that agrees best: behind an edge others see another surface.
                if (d && (own[i] < 0.0F || *d < own[i])) own[i] = *d;
            }
        }
    });
    return distances;
}

}  // namespace gripscan
