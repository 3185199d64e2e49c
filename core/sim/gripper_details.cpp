#include "core/sim/gripper_details.h"

namespace gripscan::sim {
namespace {

Material finish(double albedo, double gloss) {
    Material material;
    material.albedo = albedo;
    material.gloss = gloss;
    return material;
}

}  // namespace

Material blasted_aluminium() {
    return finish(0.56, 0.05);
}
Material blasted_steel() {
    return finish(0.46, 0.08);
}
Material dark_plastic() {
    return finish(0.26, 0.04);
}
Material light_plastic() {
    return finish(0.66, 0.03);
}

Part box_part(const char* name, const Eigen::Vector3d& size_m, const Eigen::Vector3d& centre_m,
              const Material& material, double chamfer_m) {
    return {name, moved(chamfered_box(size_m, chamfer_m), frame_at(centre_m)), material};
}

std::vector<Part> adapter() {
    Part plate{"adapter", cylinder(0.036, 0.0, 0.014, 0.0015), blasted_steel()};
    append(plate.mesh, cylinder(0.026, 0.013, 0.030));
    for (int i = 0; i < 4; ++i) {  // heads of the screws into the flange
        const double a = 0.785398 + 1.570796 * i;
        append(plate.mesh, cylinder(0.0035, 0.013, 0.0175, 0.0005),
               frame_at({0.031 * std::cos(a), 0.031 * std::sin(a), 0.0}));
    }
    return {plate};
}

std::vector<Part> sensor(const Pose& T_tool_sensor) {
    Part block{"sensor", moved(chamfered_box({0.024, 0.032, 0.034}, 0.002), T_tool_sensor),
               dark_plastic()};
    Part lens{"lens", moved(cylinder(0.008, 0.016, 0.023), T_tool_sensor), light_plastic()};
    return {block, lens};
}

std::vector<Part> hose_fitting(const Pose& T_tool_fitting) {
    Part body{"fitting", cylinder(0.0075, 0.0, 0.014, 0.0007), blasted_steel()};
    append(body.mesh, sphere(0.0078), frame_at({0, 0, 0.0155}));
    Part hose{"hose",
              moved(capsule(0.0055, 0.022), frame_at({0, 0, 0.0155}, Eigen::Vector3d::UnitX())),
              light_plastic()};
    body.mesh = moved(body.mesh, T_tool_fitting);
    hose.mesh = moved(hose.mesh, T_tool_fitting);
    return {body, hose};
}

}  // namespace gripscan::sim
