#include "core/recognition/scene_view.h"

#include <algorithm>

#include "core/base/median.h"
#include "core/cloud/filters.h"

namespace gripscan {
namespace {

constexpr std::size_t kFewestPoints = 100;

/// At most so many points, every n-th: coarse scenes need no more, and time is short.
OrientedPoints some_of(const OrientedPoints& all) {
    constexpr std::size_t kEnough = 80000;
    const std::size_t stride = (all.size() + kEnough - 1) / kEnough;
    if (stride <= 1) return all;
    OrientedPoints some;
    for (std::size_t i = 0; i < all.size(); i += stride) some.add(all.points[i], all.normals[i]);
    return some;
}

}  // namespace

CoarseScene SceneView::coarse(double step_m) const {
    CoarseScene scene;
    scene.points = step_m > 1.2 * thin_m ? thinned_by_normal(thin, step_m) : thin;
    scene.tree = KdTree(scene.points.points);
    return scene;
}

Result<SceneView> make_scene_view(const Cloud& cloud, double finest_step_m,
                                  const ForEach& for_each) {
    if (cloud.size() < kFewestPoints) {
        return input_error("the scene has only {} points; recognition wants at least {}",
                           cloud.size(), kFewestPoints);
    }
    const Eigen::Vector3f viewpoint = cloud.viewpoint.value_or(Eigen::Vector3f::Zero());
    SceneView view{.points = {cloud.points, cloud.normals},
                   .noise_m = 0.0,
                   .map = ViewMap(cloud, viewpoint),
                   .thin = {},
                   .thin_m = 0.5 * finest_step_m};
    if (!cloud.has_normals() || !cloud.viewpoint) {
        Cloud computed = cloud;
        computed.viewpoint = viewpoint;
        estimate_normals(computed, {}, for_each);
        view.points.normals = std::move(computed.normals);
    }
    view.noise_told = !cloud.sigma.empty();
    view.noise_m = cloud.sigma.empty() ? noise_estimate_m(cloud, for_each)
                                       : static_cast<double>(median_of(cloud.sigma));
    view.thin = thinned_by_normal(some_of(view.points), view.thin_m);
    return view;
}

}  // namespace gripscan
