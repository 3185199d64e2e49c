#include <cmath>

#include "core/cloud/blocks.h"
#include "core/cloud/filters.h"
#include "core/cloud/kd_tree.h"
#include "core/cloud/local_plane_fit.h"

namespace gripscan {

double noise_estimate_m(const Cloud& cloud, const ForEach& for_each, int neighbours) {
    const auto k = static_cast<std::size_t>(neighbours);
    if (k < 4 || cloud.size() < k) return 0.0;
    // A few thousand places tell the median well enough.
    constexpr std::size_t kPlaces = 4000;
    const std::size_t stride = cloud.size() / kPlaces + 1;
    const std::size_t places = (cloud.size() + stride - 1) / stride;
    const KdTree tree(cloud.points);
    std::vector<double> variances(places, 0.0);
    for_each_block(places, for_each, [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> found;
        std::vector<Eigen::Vector3f> near;
        for (std::size_t i = begin; i < end; ++i) {
            tree.k_nearest(cloud.points[i * stride], k, found);
            near.clear();
            for (const Neighbour& n : found) near.push_back(cloud.points[n.index]);
            const auto plane = fit_plane(near);
            if (plane) variances[i] = plane->variance_m2;
        }
    });
    const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(places / 2);
    std::nth_element(variances.begin(), middle, variances.end());
    // Each variance is chi-squared with k − 3 degrees of freedom, whose median lies below its
    // mean by this factor (Wilson and Hilferty 1931).
    const double freedom = static_cast<double>(k) - 3.0;
    const double median_over_mean = std::pow(1.0 - 2.0 / (9.0 * freedom), 3.0);
    return std::sqrt(*middle / median_over_mean);
}

}  // namespace gripscan
