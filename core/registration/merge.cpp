#include "core/registration/merge.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/cloud/kd_tree.h"
#include "core/registration/surface.h"
#include "core/registration/visibility.h"

namespace gripscan {
namespace {

/// Normals that may belong to the same side of a wall.
constexpr float kSameSide = 0.3F;
/// Cosine of the viewing angle up to which a view is expected to see a surface.
constexpr float kFacing = 0.5F;
/// Least share of the views that could have seen a point which must have seen it.
constexpr double kLeastConfirmed = 0.55;
/// How much a view counts that has no data where it could have seen the point: stereo may have
/// failed there, or there is nothing.
constexpr double kBlank = 0.5;
/// Radius of the surface around a point that is averaged, in voxels.
constexpr float kRadius = 1.5F;
/// Sizes of blocks of template points that one turn of a loop works on.
constexpr std::size_t kBlock = 2048;

/// All points of all views in the common frame.
struct Gathered {
    std::vector<Eigen::Vector3f> points;
    std::vector<Eigen::Vector3f> normals;
    std::vector<float> intensity;
    std::vector<float> sigma_m;  ///< along the normal
    std::vector<std::uint16_t> view;
};

Gathered gather(std::span<const PosedView> views) {
    Gathered all;
    for (std::size_t k = 0; k < views.size(); ++k) {
        const Cloud& cloud = *views[k].cloud;
        const Eigen::Matrix3f R = views[k].T_first_view.linear().cast<float>();
        const Eigen::Vector3f t = views[k].T_first_view.translation().cast<float>();
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            all.points.push_back(R * cloud.points[i] + t);
            all.normals.push_back(R * cloud.normals[i]);
            all.intensity.push_back(cloud.intensity.empty() ? 0.0F : cloud.intensity[i]);
            float sigma = cloud.sigma.empty() ? 1e-3F : cloud.sigma[i];
            if (!cloud.sigma.empty() && cloud.viewpoint) {
                const Eigen::Vector3f ray = (cloud.points[i] - *cloud.viewpoint).normalized();
                // A grazing surface has little noise along its normal, but is not known that well.
                sigma *= std::max(0.3F, std::abs(cloud.normals[i].dot(ray)));
            }
            all.sigma_m.push_back(std::max(sigma, 1e-6F));
            all.view.push_back(static_cast<std::uint16_t>(k));
        }
    }
    return all;
}

struct Seed {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    int count = 0;
};

/// One or two rough points a voxel: the mean of what lies in it, by side.
std::vector<Seed> seeds(const Gathered& all, double voxel_m) {
    std::unordered_map<std::int64_t, std::uint32_t> place;
    place.reserve(all.points.size() / 4);
    std::vector<Seed> list;
    const auto scale = static_cast<float>(1.0 / voxel_m);
    for (std::size_t i = 0; i < all.points.size(); ++i) {
        const Eigen::Array3f cube = (all.points[i] * scale).array().floor();
        const auto part = [](float x) {
            return (static_cast<std::int64_t>(x) + (1 << 19)) & 0xfffff;
        };
        const std::int64_t key = part(cube.x()) << 41 | part(cube.y()) << 21 | part(cube.z()) << 1;
        for (const std::int64_t side : {0, 1}) {
            const auto [entry, fresh] =
                place.try_emplace(key | side, static_cast<std::uint32_t>(list.size()));
            if (fresh) list.emplace_back();
            Seed& seed = list[entry->second];
            if (!fresh && seed.normal.dot(all.normals[i]) < 0.0F) continue;
            seed.sum += all.points[i];
            seed.normal += all.normals[i];
            ++seed.count;
            break;
        }
    }
    return list;
}

struct Smoothed {
    Eigen::Vector3f point = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    float intensity = 0.0F;
    float sigma_m = 0.0F;
    std::uint16_t seen = 0;
};

/// The surface around a seed: neighbours of the same side, each view's share weighted with its
/// noise, averaged along the normal. Layers that noise has left in neighbouring voxels fall
/// together.
Smoothed smooth(const Gathered& all, const KdTree& tree, const Seed& seed, float radius_m,
                std::vector<Neighbour>& found) {
    Smoothed result;
    Eigen::Vector3f point = seed.sum / static_cast<float>(seed.count);
    Eigen::Vector3f normal = seed.normal.normalized();
    for (int round = 0; round < 2; ++round) {
        tree.all_within(point, radius_m, found);
        double weight = 0.0, height = 0.0, square = 0.0, light = 0.0;
        Eigen::Vector3f normals = Eigen::Vector3f::Zero();
        std::vector<std::uint16_t> views;
        for (const Neighbour& n : found) {
            if (all.normals[n.index].dot(normal) < kSameSide) continue;
            const double h = normal.dot(all.points[n.index] - point);
            const double near = 1.0 - n.squared_distance_m2 / (radius_m * radius_m);
            const double sigma = all.sigma_m[n.index];
            const double w = near / (sigma * sigma);
            weight += w;
            height += w * h;
            square += w * h * h;
            light += w * all.intensity[n.index];
            normals += static_cast<float>(w) * all.normals[n.index];
            views.push_back(all.view[n.index]);
        }
        if (weight <= 0.0) return result;
        height /= weight;
        std::sort(views.begin(), views.end());
        views.erase(std::unique(views.begin(), views.end()), views.end());
        point += static_cast<float>(height) * normal;
        normal = normals.normalized();
        result.seen = static_cast<std::uint16_t>(views.size());
        // Points of one view share their error; views are independent of each other.
        result.sigma_m = static_cast<float>(
            std::sqrt(std::max(0.0, square / weight - height * height) /
                      static_cast<double>(std::max<std::size_t>(1, views.size()))));
        result.intensity = static_cast<float>(light / weight);
    }
    result.point = point;
    result.normal = normal;
    return result;
}

/// What the camera of a view saw, in its own frame.
struct Witness {
    DepthMap map;
    std::optional<DepthMap> holder;
    Pose T_view_first;
    Eigen::Vector3f viewpoint;
};

/// One of every view whose viewpoint is known, in their order.
std::vector<Witness> witnesses(std::span<const PosedView> views, const ForEach& for_each) {
    std::vector<std::optional<Witness>> made(views.size());
    for_each(views.size(), [&](std::size_t k) {
        const auto& viewpoint = views[k].cloud->viewpoint;
        if (!viewpoint) return;
        if (const auto surface = make_surface(*views[k].cloud)) {
            made[k].emplace(Witness{DepthMap(*surface), std::nullopt,
                                    views[k].T_first_view.inverse(), *viewpoint});
            const Surface* holder = views[k].holder;
            if (holder != nullptr && holder->viewpoint) made[k]->holder.emplace(*holder);
        }
    });
    std::vector<Witness> known;
    for (auto& witness : made) {
        if (witness) known.push_back(std::move(*witness));
    }
    return known;
}

bool behind_holder(const Witness& view, const Eigen::Vector3f& p, float tolerance_m) {
    return view.holder && view.holder->look(p, tolerance_m) == Sight::kHidden;
}

/// Of the views that could have seen the point (it faces them and nothing they saw hides it), the
/// share that did. Debris at silhouettes is seen by a few views and looked through by the others.
double confirmed_share(const Smoothed& s, const std::vector<Witness>& views, float tolerance_m) {
    double could_see = 0.0;
    for (const Witness& view : views) {
        const Pose& T = view.T_view_first;
        const Eigen::Vector3f p = (T * s.point.cast<double>()).cast<float>();
        const Eigen::Vector3f n = (T.linear() * s.normal.cast<double>()).cast<float>();
        const Eigen::Vector3f ray = (p - view.viewpoint).normalized();
        if (-n.dot(ray) < kFacing) continue;
        const Sight sight = view.map.look(p, tolerance_m);
        if (sight == Sight::kHidden || behind_holder(view, p, tolerance_m)) continue;
        could_see += sight == Sight::kNothing ? kBlank : 1.0;
    }
    return s.seen / std::max<double>(could_see, s.seen);
}

}  // namespace

Cloud merge_views(std::span<const PosedView> views, const MergeSettings& settings,
                  const ForEach& for_each) {
    Cloud merged;
    const Gathered all = gather(views);
    if (all.points.empty()) return merged;
    const std::vector<Seed> rough = seeds(all, settings.voxel_m);
    const KdTree tree(all.points);
    const std::vector<Witness> seen_by = witnesses(views, for_each);
    const auto radius_m = static_cast<float>(kRadius * settings.voxel_m);
    const auto tolerance_m = static_cast<float>(3.0 * settings.voxel_m);
    std::vector<Smoothed> fine(rough.size());
    for_each((rough.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
        std::vector<Neighbour> found;
        const std::size_t end = std::min(rough.size(), (block + 1) * kBlock);
        for (std::size_t i = block * kBlock; i < end; ++i) {
            if (rough[i].count == 0) continue;
            fine[i] = smooth(all, tree, rough[i], radius_m, found);
            if (fine[i].seen < settings.min_seen ||
                confirmed_share(fine[i], seen_by, tolerance_m) < kLeastConfirmed) {
                fine[i].seen = 0;
            }
        }
    });
    for (const Smoothed& s : fine) {
        if (s.seen == 0) continue;
        merged.points.push_back(s.point);
        merged.normals.push_back(s.normal);
        merged.intensity.push_back(s.intensity);
        merged.sigma.push_back(s.sigma_m);
        merged.seen.push_back(s.seen);
    }
    return merged;
}

}  // namespace gripscan
