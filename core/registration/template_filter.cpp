#include "core/registration/template_filter.h"

#include <algorithm>
#include <cmath>

#include "core/base/median.h"
#include "core/cloud/blocks.h"
#include "core/cloud/kd_tree.h"

namespace gripscan {
namespace {

using Indices = std::vector<std::size_t>;

Indices inside_crop(const Cloud& cloud, const TemplateFilter& filter) {
    Indices left;
    left.reserve(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const bool inside = !filter.crop || filter.crop->contains(cloud.points[i].cast<double>());
        if (inside != (filter.crop && filter.invert_crop)) left.push_back(i);
    }
    return left;
}

std::vector<std::size_t> seen_histogram(const Cloud& cloud, const Indices& indices) {
    std::vector<std::size_t> seen_by;
    if (cloud.seen.empty()) return seen_by;
    for (const std::size_t i : indices) {
        const std::size_t views = cloud.seen[i];
        if (views >= seen_by.size()) seen_by.resize(views + 1, 0);
        ++seen_by[views];
    }
    return seen_by;
}

std::vector<Eigen::Vector3f> points_of(const Cloud& cloud, const Indices& indices) {
    std::vector<Eigen::Vector3f> points;
    points.reserve(indices.size());
    for (const std::size_t i : indices) points.push_back(cloud.points[i]);
    return points;
}

/// Of every point to its `neighbours` nearest ones.
std::vector<double> mean_distances_m(const std::vector<Eigen::Vector3f>& points, int neighbours,
                                     const ForEach& for_each) {
    const KdTree tree(points);
    const auto k = static_cast<std::size_t>(std::max(1, neighbours)) + 1;  // itself is the first
    std::vector<double> means(points.size(), 0.0);
    for_each_block(points.size(), for_each, [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> found;
        for (std::size_t i = begin; i < end; ++i) {
            tree.k_nearest(points[i], k, found);
            double sum = 0.0;
            for (const Neighbour& n : found) sum += std::sqrt(n.squared_distance_m2);
            if (found.size() > 1) means[i] = sum / static_cast<double>(found.size() - 1);
        }
    });
    return means;
}

double limit_m(const std::vector<double>& distances, double sigmas) {
    const auto n = static_cast<double>(distances.size());
    double sum = 0.0;
    for (const double d : distances) sum += d;
    const double mean = sum / n;
    double squares = 0.0;
    for (const double d : distances) squares += (d - mean) * (d - mean);
    return mean + sigmas * std::sqrt(squares / n);
}

Indices without_outliers(const Cloud& cloud, const Indices& indices, const TemplateFilter& filter,
                         const ForEach& for_each) {
    if (filter.denoise_sigmas <= 0.0 || indices.size() < 2) return indices;
    const auto distances =
        mean_distances_m(points_of(cloud, indices), filter.denoise_neighbours, for_each);
    const double limit = limit_m(distances, filter.denoise_sigmas);
    Indices left;
    left.reserve(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (distances[i] <= limit) left.push_back(indices[i]);
    }
    return left;
}

Box bounds_of(const Cloud& cloud) {
    Eigen::AlignedBox3f bounds;
    for (const Eigen::Vector3f& p : cloud.points) bounds.extend(p);
    return {bounds.min().cast<double>(), bounds.max().cast<double>()};
}

}  // namespace

FilteredTemplate filter_template(const Cloud& cloud, const TemplateFilter& filter,
                                 const ForEach& for_each) {
    FilteredTemplate result;
    FilterCounts& counts = result.counts;
    counts.all = cloud.size();
    Indices left = inside_crop(cloud, filter);
    counts.cut_off = counts.all - left.size();
    counts.seen_by = seen_histogram(cloud, left);
    if (!cloud.seen.empty()) {
        counts.too_few =
            std::erase_if(left, [&](std::size_t i) { return cloud.seen[i] < filter.min_seen; });
    }
    result.kept = without_outliers(cloud, left, filter, for_each);
    counts.outliers = left.size() - result.kept.size();
    counts.kept = result.kept.size();
    return result;
}

TemplateFacts template_facts(const Cloud& cloud, const ForEach& for_each) {
    TemplateFacts facts;
    facts.points = cloud.size();
    facts.has_normals = cloud.has_normals();
    if (cloud.empty()) return facts;
    facts.bounds = bounds_of(cloud);
    facts.spacing_m = median_of(mean_distances_m(cloud.points, 1, for_each));
    if (!cloud.sigma.empty()) facts.sigma_m = static_cast<double>(median_of(cloud.sigma));
    return facts;
}

}  // namespace gripscan
