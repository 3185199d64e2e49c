#include "core/scene/gripper_template.h"

#include "core/cloud/filters.h"

namespace gripscan {
namespace {

constexpr double kThin_m = 0.0012;
constexpr std::size_t kFewestPoints = 500;

}  // namespace

Result<GripperTemplate> make_gripper_template(Cloud cloud, const Axis& axis,
                                              std::optional<double> joint6_rad) {
    if (cloud.size() < kFewestPoints) {
        return input_error("the gripper's template has {} points; matching wants at least {}",
                           cloud.size(), kFewestPoints);
    }
    if (!cloud.has_normals()) estimate_normals(cloud, {}, for_each_in_order);
    GripperTemplate result;
    result.thin = thinned(cloud, kThin_m);
    result.cuboid = cuboid_along(cloud.points, axis.direction);
    result.cloud = std::move(cloud);
    result.axis = axis;
    result.joint6_rad = joint6_rad;
    return result;
}

}  // namespace gripscan
