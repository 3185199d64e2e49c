#include "core/scene/left_over.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/base/units.h"
#include "core/cloud/kd_tree.h"

namespace gripscan {
namespace {

/// Extents that leave out the outermost hundredth on either side: flying points are few.
double extent_along(const Cloud& scene, const std::vector<std::size_t>& points,
                    const Eigen::Vector3d& axis) {
    std::vector<double> along;
    along.reserve(points.size());
    for (const std::size_t i : points) along.push_back(axis.dot(scene.points[i].cast<double>()));
    std::sort(along.begin(), along.end());
    const std::size_t cut = along.size() / 100;
    return along[along.size() - 1 - cut] - along[cut];
}

void measure(const Cloud& scene, LeftOver& thing) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::size_t i : thing.points) sum += scene.points[i].cast<double>();
    thing.centre_m = sum / static_cast<double>(thing.points.size());
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const std::size_t i : thing.points) {
        const Eigen::Vector3d d = scene.points[i].cast<double>() - thing.centre_m;
        moments += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
    // Eigenvalues rise; the longest side comes first.
    for (int k = 0; k < 3; ++k) {
        thing.axes.col(k) = solver.eigenvectors().col(2 - k);
        thing.size_m(k) = extent_along(scene, thing.points, thing.axes.col(k));
    }
}

}  // namespace

std::vector<std::size_t> without_known(const Cloud& scene, const std::vector<std::size_t>& indices,
                                       std::span<const KnownThing> things) {
    std::vector<std::size_t> left = indices;
    for (const KnownThing& thing : things) {
        if (thing.cloud == nullptr || thing.cloud->empty()) continue;
        const KdTree tree(thing.cloud->points);
        const Eigen::Isometry3f T_cloud_camera = thing.T_camera_cloud.inverse().cast<float>();
        const auto margin = static_cast<float>(thing.margin_m);
        std::erase_if(left, [&](std::size_t i) {
            return tree.nearest_within(T_cloud_camera * scene.points[i], margin).has_value();
        });
    }
    return left;
}

std::vector<LeftOver> find_left_overs(const Cloud& scene, const std::vector<std::size_t>& indices,
                                      const LeftOverSettings& settings) {
    std::vector<Eigen::Vector3f> points;
    points.reserve(indices.size());
    for (const std::size_t i : indices) points.push_back(scene.points[i]);
    std::vector<LeftOver> things;
    if (points.empty()) return things;
    const KdTree tree(points);
    std::vector<char> taken(points.size(), 0);
    std::vector<Neighbour> near;
    for (std::size_t start = 0; start < points.size(); ++start) {
        if (taken[start] != 0) continue;
        std::vector<std::size_t> members{start};
        taken[start] = 1;
        for (std::size_t next = 0; next < members.size(); ++next) {
            tree.all_within(points[members[next]], static_cast<float>(settings.gap_m), near);
            for (const Neighbour& n : near) {
                if (taken[n.index] != 0) continue;
                taken[n.index] = 1;
                members.push_back(n.index);
            }
        }
        if (members.size() < settings.least_points) continue;
        LeftOver thing;
        for (const std::size_t m : members) thing.points.push_back(indices[m]);
        std::sort(thing.points.begin(), thing.points.end());
        measure(scene, thing);
        if (thing.size_m.x() >= settings.least_size_m) things.push_back(std::move(thing));
    }
    std::stable_sort(things.begin(), things.end(), [](const LeftOver& a, const LeftOver& b) {
        return a.points.size() > b.points.size();
    });
    return things;
}

std::string sentence(const LeftOver& thing) {
    const Eigen::Vector3d size = kMmPerM * thing.size_m;
    const Eigen::Vector3d at = kMmPerM * thing.centre_m;
    return fmt::format(
        "something is in the way: {:.0f} x {:.0f} x {:.0f} mm at x {:.0f}, y {:.0f}, z {:.0f} mm",
        size.x(), size.y(), size.z(), at.x(), at.y(), at.z());
}

}  // namespace gripscan
