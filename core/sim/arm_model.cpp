#include "core/sim/arm_model.h"

namespace gripscan::sim {
namespace {

using Eigen::Vector3d;

Material paint() {
    Material material;
    material.albedo = 0.62;
    material.gloss = 0.10;
    // Paint is smoother than a blasted surface: soft stains, weak grain.
    material.texture = {.cell_m = 0.030, .octaves = 4, .gain = 0.9, .contrast = 0.06};
    return material;
}

Material casting() {
    Material material = paint();
    material.albedo = 0.34;
    return material;
}

/// A cylinder across the arm (along y), such as a joint's housing.
Mesh across(double radius_m, double half_length_m, const Vector3d& centre_m) {
    Mesh mesh = cylinder(radius_m, -half_length_m, half_length_m, 0.006);
    return moved(mesh, frame_at(centre_m, Vector3d::UnitY()));
}

Mesh box_at(const Vector3d& size_m, const Vector3d& centre_m, double chamfer_m) {
    return moved(chamfered_box(size_m, chamfer_m), frame_at(centre_m));
}

Part base() {
    Part part{"base", cylinder(0.110, 0.0, 0.190, 0.010), paint()};
    append(part.mesh, box_at({0.30, 0.26, 0.03}, {-0.02, 0, 0.015}, 0.005));
    return part;
}

Part shoulder() {
    Part part{"shoulder", cylinder(0.100, -0.135, -0.02, 0.008), paint()};
    append(part.mesh, across(0.085, 0.090, {0.075, 0, 0}));
    append(part.mesh, box_at({0.17, 0.15, 0.11}, {0.03, 0, -0.015}, 0.012));
    return part;
}

Part upper_arm() {
    Part part{"upper arm", box_at({0.105, 0.072, 0.40}, {0, 0, 0.200}, 0.016), paint()};
    append(part.mesh, across(0.078, 0.052, {0, 0, 0}));
    append(part.mesh, across(0.066, 0.052, {0, 0, 0.400}));
    return part;
}

Part elbow() {
    Part part{"elbow", across(0.060, 0.078, {0, 0, 0}), paint()};
    append(part.mesh, box_at({0.20, 0.130, 0.135}, {-0.005, 0, 0.060}, 0.018));
    append(part.mesh, moved(cylinder(0.056, 0.0, 0.030, 0.004),
                            frame_at({0.094, 0, 0.075}, Vector3d::UnitX())));
    return part;
}

Part forearm() {
    const Mesh tube = lathe({{0.052, 0.0}, {0.054, 0.010}, {0.046, 0.150}, {0.044, 0.205}});
    Part part{"forearm", moved(tube, frame_at({0.126, 0, 0}, Vector3d::UnitX())), paint()};
    append(part.mesh, box_at({0.085, 0.016, 0.070}, {0.368, 0.040, 0}, 0.004));
    append(part.mesh, box_at({0.085, 0.016, 0.070}, {0.368, -0.040, 0}, 0.004));
    append(part.mesh, box_at({0.030, 0.080, 0.070}, {0.330, 0, 0}, 0.004));
    append(part.mesh, across(0.036, 0.050, {0.410, 0, 0}));
    return part;
}

Part wrist() {
    Part part{"wrist", across(0.034, 0.031, {0, 0, 0}), casting()};
    append(part.mesh, moved(cylinder(0.034, 0.0, 0.054, 0.003),
                            frame_at(Vector3d::Zero(), Vector3d::UnitX())));
    return part;
}

/// Turns with joint 6: from the wrist's front to the face at x = 0 of its frame.
Part flange() {
    Part part{"flange",
              moved(cylinder(0.0315, -0.023, 0.0), frame_at(Vector3d::Zero(), Vector3d::UnitX())),
              casting()};
    part.material.albedo = 0.48;
    return part;
}

}  // namespace

std::array<std::vector<Part>, 7> make_arm() {
    return {{{base()}, {shoulder()}, {upper_arm()}, {elbow()}, {forearm()}, {wrist()}, {flange()}}};
}

}  // namespace gripscan::sim
