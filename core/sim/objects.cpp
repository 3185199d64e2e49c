#include "core/sim/objects.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "core/sim/gripper_details.h"

namespace gripscan::sim {
namespace {

using Eigen::Vector3d;

Material cardboard() {
    Material material;
    material.albedo = 0.62;
    return material;
}

Material cast_iron() {
    Material material;
    material.albedo = 0.36;
    material.gloss = 0.05;
    return material;
}

/// A carton with a raised label on one side and a cut corner block, so that no turn maps it to
/// itself.
std::vector<Part> carton(double w) {
    return {box_part("carton", {w, 0.074, 0.086}, {0, 0.004, 0.026}, cardboard(), 0.0015),
            box_part("label", {0.6 * w, 0.003, 0.040}, {0.1 * w, 0.0415, 0.040}, light_plastic(),
                     0.0008),
            box_part("clip", {0.3 * w, 0.020, 0.008}, {-0.2 * w, -0.016, 0.072}, dark_plastic())};
}

/// A jug: a curved body with a spout and a handle.
std::vector<Part> jug(double w) {
    const double r = w / 2.0;
    Part body{"jug",
              lathe({{0.92 * r, -0.022},
                     {r, -0.018},
                     {r, 0.014},
                     {1.3 * r, 0.034},
                     {1.35 * r, 0.050},
                     {0.8 * r, 0.070},
                     {0.75 * r, 0.082}}),
              cardboard()};
    append(body.mesh, cone(0.010, 0.006, 0.0, 0.026),
           frame_at({0.9 * r, 0.0, 0.058}, {0.8, 0.0, 0.6}));
    Part handle{"handle", {}, light_plastic()};
    const Vector3d bow[] = {
        {0, 1.2 * r, 0.034}, {0, 1.75 * r, 0.040}, {0, 1.8 * r, 0.066}, {0, 0.7 * r, 0.074}};
    for (int i = 0; i < 3; ++i) {
        const Vector3d step = bow[i + 1] - bow[i];
        append(handle.mesh, capsule(0.0055, step.norm()), frame_at(bow[i], step.normalized()));
    }
    return {body, handle};
}

/// A flat bracket: an L-shaped plate with a hooked end, and a boss.
std::vector<Part> bracket(double w) {
    const std::vector<Eigen::Vector2d> outline = {
        {-0.030, -0.022}, {0.030, -0.022}, {0.030, 0.010},  {0.012, 0.016}, {0.012, 0.046},
        {0.052, 0.050},   {0.052, 0.068},  {-0.012, 0.068}, {-0.030, 0.040}};
    Pose T = Pose::Identity();  // outline x → y, outline y → z, thickness along x
    T.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    Part plate{"bracket", moved(extrusion(outline, -0.007, 0.007), T), cast_iron()};
    append(plate.mesh,
           moved(extrusion({{-0.030, -0.022}, {0.030, -0.022}, {0.030, 0.008}, {-0.030, 0.008}},
                           -w / 2.0, w / 2.0),
                 T));
    append(plate.mesh, cylinder(0.011, 0.0, 0.020),
           frame_at({0.0, 0.034, 0.058}, Vector3d::UnitX()));
    return {plate};
}

/// A hexagonal nut blank: six turns of 60° look nearly the same; a small tab tells them apart.
std::vector<Part> hexagon(double w) {
    std::vector<Eigen::Vector2d> outline;
    for (int i = 0; i < 6; ++i) {
        const double a = std::numbers::pi * (i + 0.5) / 3.0;
        outline.emplace_back(w / std::sqrt(3.0) * std::cos(a), w / std::sqrt(3.0) * std::sin(a));
    }
    Part body{"hexagon", extrusion(outline, -0.022, 0.052), cast_iron()};
    append(body.mesh, cylinder(0.62 * w, 0.050, 0.062));
    return {body, box_part("tab", {0.012, 0.010, 0.014}, {0.0, w / 2.0 + 0.003, 0.036},
                           light_plastic(), 0.001)};
}

/// A casting with a curved pipe stub: nothing about it repeats.
std::vector<Part> casting(double w) {
    Part body{"casting", moved(chamfered_box({w, 0.060, 0.050}, 0.004), frame_at({0, 0, 0.006})),
              cast_iron()};
    append(body.mesh, cylinder(0.022, 0.0, 0.046, 0.002),
           frame_at({0.004, 0.008, 0.028}, {0.30, 0.25, 0.92}));
    append(body.mesh, sphere(0.020), frame_at({-0.008, -0.030, 0.022}));
    append(body.mesh, cone(0.014, 0.007, 0.0, 0.030),
           frame_at({0.010, 0.028, 0.014}, {0.2, 0.95, 0.25}));
    return {body};
}

const std::map<std::string, std::function<std::vector<Part>(double)>>& makers() {
    static const std::map<std::string, std::function<std::vector<Part>(double)>> table = {
        {"carton", carton},
        {"jug", jug},
        {"bracket", bracket},
        {"hexagon", hexagon},
        {"casting", casting}};
    return table;
}

}  // namespace

std::vector<std::string> object_names() {
    return {"carton", "jug", "bracket", "hexagon", "casting"};
}

std::vector<Part> make_object(const std::string& name, double opening_m) {
    const auto maker = makers().find(name);
    if (maker == makers().end()) return {};
    constexpr double kWidthForSuction_m = 0.100;
    std::vector<Part> parts = maker->second(opening_m > 0.0 ? opening_m : kWidthForSuction_m);
    if (opening_m > 0.0) return parts;
    double back_m = 0.0;
    for (const Part& part : parts) {
        for (const Vector3d& v : part.mesh.vertices) back_m = std::min(back_m, v.z());
    }
    for (Part& part : parts) part.mesh = moved(part.mesh, frame_at({0, 0, -back_m}));
    return parts;
}

}  // namespace gripscan::sim
