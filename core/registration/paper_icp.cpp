// The only file that includes PCL's registration headers: they take long to compile.
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/cloud/kd_tree.h"
#include "core/registration/align.h"

namespace gripscan {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

PclCloud::Ptr pcl_from(const Cloud& cloud, double voxel_m) {
    PclCloud::Ptr result(new PclCloud);
    result->reserve(cloud.size());
    for (const auto& p : cloud.points) result->push_back({p.x(), p.y(), p.z()});
    if (voxel_m <= 0.0) return result;
    PclCloud::Ptr thinned(new PclCloud);
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    const auto edge = static_cast<float>(voxel_m);
    grid.setLeafSize(edge, edge, edge);
    grid.setInputCloud(result);
    grid.filter(*thinned);
    return thinned;
}

/// Residuals of the pairs ICP itself has used: nearest neighbours within its distance.
void measure(const Cloud& source, const Cloud& target, double gate_m, Alignment& a) {
    const KdTree tree(target.points);
    std::vector<double> distance_m;
    double squares = 0.0;
    for (const auto& p : source.points) {
        const Eigen::Vector3f moved = (a.T_target_source * p.cast<double>()).cast<float>();
        const auto found = tree.nearest_within(moved, static_cast<float>(gate_m));
        if (!found) continue;
        squares += found->squared_distance_m2;
        distance_m.push_back(std::sqrt(found->squared_distance_m2));
    }
    if (distance_m.empty()) return;
    std::sort(distance_m.begin(), distance_m.end());
    a.overlap = static_cast<double>(distance_m.size()) / static_cast<double>(source.size());
    a.rms_m = std::sqrt(squares / static_cast<double>(distance_m.size()));
    a.median_m = distance_m[distance_m.size() / 2];
    a.p90_m = distance_m[distance_m.size() * 9 / 10];
}

}  // namespace

Result<Alignment> align_paper_icp(const Cloud& source, const Cloud& target,
                                  const PaperIcpSettings& settings) {
    if (source.size() < 10 || target.size() < 10) {
        return input_error("ICP wants at least 10 points a cloud, there are {} and {}",
                           source.size(), target.size());
    }
    pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
    icp.setMaxCorrespondenceDistance(settings.max_correspondence_m);
    icp.setMaximumIterations(settings.iterations);
    icp.setTransformationEpsilon(settings.transformation_epsilon);
    icp.setInputSource(pcl_from(source, settings.voxel_m));
    icp.setInputTarget(pcl_from(target, settings.voxel_m));
    PclCloud moved;
    icp.align(moved);
    Alignment a;
    a.found = icp.hasConverged();
    if (!a.found) {
        a.sentence = "PCL's ICP did not converge";
        return a;
    }
    const Eigen::Matrix4d M = icp.getFinalTransformation().cast<double>();
    // Single precision leaves the rotation a little off; the nearest rotation is meant.
    a.T_target_source.linear() = Eigen::Quaterniond(Eigen::Matrix3d(M.topLeftCorner<3, 3>()))
                                     .normalized()
                                     .toRotationMatrix();
    a.T_target_source.translation() = M.topRightCorner<3, 1>();
    const Eigen::Vector3d turn = rotation_vector(a.T_target_source.linear());
    a.angle_rad = turn.norm();
    if (a.angle_rad > 1e-9) a.axis = turn / a.angle_rad;
    a.starts_agree = true;
    measure(source, target, settings.max_correspondence_m, a);
    a.verdict = Verdict::kAccept;
    a.cause = Cause::kNone;
    a.sentence = fmt::format("ICP turned by {:.3f} deg", deg_from_rad(a.angle_rad));
    return a;
}

}  // namespace gripscan
