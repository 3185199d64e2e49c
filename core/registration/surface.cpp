#include "core/registration/surface.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/cloud/filters.h"

namespace gripscan {
namespace {

constexpr std::size_t kFewestPoints = 100;
/// Squared width over length below which a cloud is a line.
constexpr double kThinnest = 1e-6;

/// Median distance to the nearest other point, from some hundred points.
double typical_spacing_m(const KdTree& tree, const std::vector<Eigen::Vector3f>& points) {
    const std::size_t stride = std::max<std::size_t>(1, points.size() / 400);
    std::vector<float> distances;
    std::vector<Neighbour> found;
    for (std::size_t i = 0; i < points.size(); i += stride) {
        tree.k_nearest(points[i], 2, found);
        if (found.size() == 2) distances.push_back(std::sqrt(found[1].squared_distance_m2));
    }
    if (distances.empty()) return 0.0;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

/// A point of an image grid is on the rim where its neighbourhood is not filled by near points.
std::vector<std::uint8_t> rim_of_grid(const Cloud& cloud, double spacing_m) {
    constexpr int kReach = 2;
    constexpr int kFewest = 20;  // of 25: a straight edge through the centre leaves 15
    const std::vector<std::int32_t> index = point_of_cell(cloud);
    const float near_m = static_cast<float>(8.0 * spacing_m);
    std::vector<std::uint8_t> rim(cloud.size(), 0);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const int row = cloud.cell[i] / cloud.grid_width;
        const int column = cloud.cell[i] % cloud.grid_width;
        int present = 0;
        for (int r = std::max(0, row - kReach); r <= std::min(cloud.grid_height - 1, row + kReach);
             ++r) {
            for (int c = std::max(0, column - kReach);
                 c <= std::min(cloud.grid_width - 1, column + kReach); ++c) {
                const std::int32_t j =
                    index[static_cast<std::size_t>(r) * static_cast<std::size_t>(cloud.grid_width) +
                          static_cast<std::size_t>(c)];
                if (j >= 0 &&
                    (cloud.points[static_cast<std::size_t>(j)] - cloud.points[i]).norm() < near_m) {
                    ++present;
                }
            }
        }
        rim[i] = present < kFewest ? 1 : 0;
    }
    return rim;
}

/// Without a grid: on the rim where the neighbours lie to one side.
std::vector<std::uint8_t> rim_of_points(const Surface& surface) {
    constexpr std::size_t kNeighbours = 16;
    constexpr float kOffset = 0.25F;  // of the neighbourhood's radius; a half disc has 0.42
    std::vector<std::uint8_t> rim(surface.size(), 0);
    std::vector<Neighbour> found;
    for (std::size_t i = 0; i < surface.size(); ++i) {
        surface.tree.k_nearest(surface.points[i], kNeighbours, found);
        Eigen::Vector3f mean = Eigen::Vector3f::Zero();
        for (const Neighbour& n : found) mean += surface.points[n.index];
        mean /= static_cast<float>(found.size());
        const float radius = std::sqrt(found.back().squared_distance_m2);
        rim[i] = (mean - surface.points[i]).norm() > kOffset * radius ? 1 : 0;
    }
    return rim;
}

/// Points on one line (or in one spot) are no surface.
bool spans_a_surface(const Cloud& cloud) {
    const Eigen::Vector3d centre = centroid(cloud);
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto& p : cloud.points) {
        const Eigen::Vector3d d = p.cast<double>() - centre;
        spread += d * d.transpose();
    }
    const Eigen::Vector3d sizes =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly)
            .eigenvalues();
    return sizes(1) > kThinnest * sizes(2);
}

}  // namespace

Result<Surface> make_surface(const Cloud& given) {
    if (given.size() < kFewestPoints) {
        return input_error("only {} points; registration wants at least {}", given.size(),
                           kFewestPoints);
    }
    if (!spans_a_surface(given)) return input_error("all points lie on one line");
    Cloud computed;
    const Cloud* cloud = &given;
    if (!given.has_normals()) {
        computed = given;
        estimate_normals(computed, {}, for_each_in_order);
        cloud = &computed;
    }
    Surface surface{.points = cloud->points,
                    .normals = cloud->normals,
                    .rays = {},
                    .sigma_m = cloud->sigma,
                    .rim = {},
                    .tree = KdTree(cloud->points),
                    .viewpoint = cloud->viewpoint,
                    .texture = TextureGrid::create(*cloud)};
    if (surface.sigma_m.empty()) {
        surface.sigma_m.assign(surface.size(),
                               static_cast<float>(noise_estimate_m(*cloud, for_each_in_order)));
    } else if (surface.viewpoint) {
        surface.rays.reserve(surface.size());
        for (const auto& p : surface.points) {
            surface.rays.push_back((p - *surface.viewpoint).normalized());
        }
    }
    surface.centre_m = centroid(*cloud);
    double sum = 0.0;
    for (const auto& p : surface.points) {
        sum += (p.cast<double>() - surface.centre_m).squaredNorm();
    }
    surface.radius_m = std::sqrt(sum / static_cast<double>(surface.size()));
    surface.spacing_m = typical_spacing_m(surface.tree, surface.points);
    surface.rim =
        cloud->organised() ? rim_of_grid(*cloud, surface.spacing_m) : rim_of_points(surface);
    return surface;
}

std::vector<std::uint32_t> spread_sample(const Surface& surface, std::size_t count) {
    std::vector<std::uint32_t> sample;
    if (surface.size() <= count) {
        sample.resize(surface.size());
        for (std::uint32_t i = 0; i < sample.size(); ++i) sample[i] = i;
        return sample;
    }
    // A surface of n points at this spacing covers about n · spacing²; the cubes share it out.
    double edge_m = surface.spacing_m *
                    std::sqrt(static_cast<double>(surface.size()) / static_cast<double>(count));
    for (int attempt = 0; attempt < 12; ++attempt) {
        sample.clear();
        std::unordered_map<std::int64_t, bool> taken;
        taken.reserve(2 * count);
        const auto scale = static_cast<float>(1.0 / edge_m);
        const Eigen::Vector3f origin = surface.centre_m.cast<float>();
        for (std::uint32_t i = 0; i < surface.size(); ++i) {
            const Eigen::Array3f cube = ((surface.points[i] - origin) * scale).array().floor();
            const std::int64_t key = (static_cast<std::int64_t>(cube.x()) + (1 << 20)) << 42 |
                                     (static_cast<std::int64_t>(cube.y()) + (1 << 20)) << 21 |
                                     (static_cast<std::int64_t>(cube.z()) + (1 << 20));
            if (taken.try_emplace(key, true).second) sample.push_back(i);
        }
        if (sample.size() <= count) return sample;
        edge_m *= 1.02 * std::sqrt(static_cast<double>(sample.size()) / static_cast<double>(count));
    }
    sample.resize(count);
    return sample;
}

}  // namespace gripscan
