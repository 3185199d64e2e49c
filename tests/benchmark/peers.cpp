#include "tests/benchmark/peers.h"

#include <pcl/console/print.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>

#include "core/cloud/filters.h"
#include "core/registration/align.h"

namespace gripscan::test {
namespace {

constexpr double kThinned_m = 0.003;

using Points = pcl::PointCloud<pcl::PointXYZ>;
using Oriented = pcl::PointCloud<pcl::PointNormal>;

template <typename PclCloud>
typename PclCloud::Ptr to_pcl(const Cloud& cloud) {
    typename PclCloud::Ptr result(new PclCloud);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        typename PclCloud::PointType p{};
        p.getVector3fMap() = cloud.points[i];
        if constexpr (std::is_same_v<PclCloud, Oriented>) {
            p.getNormalVector3fMap() = cloud.normals[i];
        }
        result->push_back(p);
    }
    return result;
}

/// One after the other with these limits of the distance of a pair; each starts where the last one
/// ended.
template <typename PclCloud, typename Method>
std::optional<Pose> narrowed(Method& method, const Cloud& source, const Cloud& target,
                             const std::vector<double>& distances_m) {
    method.setInputSource(to_pcl<PclCloud>(thinned(source, kThinned_m)));
    method.setInputTarget(to_pcl<PclCloud>(thinned(target, kThinned_m)));
    Eigen::Matrix4f T = Eigen::Matrix4f::Identity();
    PclCloud moved;
    for (const double distance_m : distances_m) {
        method.setMaxCorrespondenceDistance(distance_m);
        method.align(moved, T);
        if (!method.hasConverged()) return std::nullopt;
        T = method.getFinalTransformation();
    }
    return Pose(T.cast<double>());
}

const std::vector<double> kNarrowing_m{0.025, 0.010, 0.004};

std::optional<Pose> gripscan_align(const Cloud& source, const Cloud& target) {
    const auto result = align(source, target, {}, {}, for_each_in_order);
    if (!result || !result->found) return std::nullopt;
    return result->T_target_source;
}

std::optional<Pose> published_icp(const Cloud& source, const Cloud& target) {
    const auto result = align_paper_icp(source, target, {.voxel_m = kThinned_m});
    if (!result || !result->found) return std::nullopt;
    return result->T_target_source;
}

std::optional<Pose> icp(const Cloud& source, const Cloud& target) {
    pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> method;
    method.setMaximumIterations(100);
    return narrowed<Points>(method, source, target, kNarrowing_m);
}

std::optional<Pose> point_to_plane(const Cloud& source, const Cloud& target) {
    pcl::IterativeClosestPointWithNormals<pcl::PointNormal, pcl::PointNormal> method;
    method.setMaximumIterations(100);
    return narrowed<Oriented>(method, source, target, kNarrowing_m);
}

std::optional<Pose> gicp(const Cloud& source, const Cloud& target) {
    pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> method;
    return narrowed<Points>(method, source, target, {0.025});
}

}  // namespace

std::vector<Peer> all_peers() {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    return {{"gripscan align", gripscan_align},
            {"PCL ICP as published", published_icp},
            {"PCL ICP, narrowed", icp},
            {"PCL point-to-plane, narrowed", point_to_plane},
            {"PCL GICP as shipped", gicp}};
}

}  // namespace gripscan::test
