#include "core/sim/grippers.h"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "core/sim/gripper_details.h"

namespace gripscan::sim {
namespace {

using Eigen::Vector3d;

void add(Gripper& gripper, const std::vector<Part>& parts) {
    gripper.parts.insert(gripper.parts.end(), parts.begin(), parts.end());
}

Pose turned_about_z(double angle_rad) {
    return Pose(Eigen::AngleAxisd(angle_rad, Vector3d::UnitZ()));
}

/// A finger, seen from the side (outline in x, z), `width` deep in y, its inner face at x = 0.
Part finger(const char* name, double length_m, double width_m, double root_m, double tip_m) {
    const std::vector<Eigen::Vector2d> outline = {{0.0, 0.0},
                                                  {root_m, 0.0},
                                                  {root_m, 0.35 * length_m},
                                                  {tip_m, 0.8 * length_m},
                                                  {tip_m, length_m - 0.003},
                                                  {tip_m - 0.003, length_m},
                                                  {0.0, length_m}};
    Pose T = Pose::Identity();  // the outline's y is the finger's z
    T.linear() = Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3d::UnitX()).toRotationMatrix();
    return {name, moved(extrusion(outline, -width_m / 2.0, width_m / 2.0), T), blasted_aluminium()};
}

Part placed(Part part, const Pose& T) {
    part.mesh = moved(part.mesh, T);
    return part;
}

Gripper two_finger() {
    constexpr double kOpening_m = 0.046;
    Gripper gripper;
    add(gripper, adapter());
    add(gripper,
        {box_part("palm", {0.122, 0.072, 0.062}, {0, 0, 0.059}, blasted_aluminium(), 0.005),
         box_part("rail", {0.130, 0.030, 0.012}, {0, 0, 0.094}, blasted_steel()),
         box_part("connector", {0.016, 0.036, 0.026}, {-0.067, 0.008, 0.054}, dark_plastic()),
         box_part("name plate", {0.046, 0.004, 0.030}, {-0.024, -0.037, 0.062}, light_plastic(),
                  0.0008),
         box_part("carriage", {0.032, 0.052, 0.014}, {0.039, 0, 0.104}, blasted_steel()),
         box_part("carriage", {0.032, 0.052, 0.014}, {-0.039, 0, 0.104}, blasted_steel())});
    const Pose right = frame_at({kOpening_m / 2.0, 0, 0.110});
    const Pose left = frame_at({-kOpening_m / 2.0, 0, 0.110}) * turned_about_z(std::numbers::pi);
    add(gripper, {placed(finger("finger", 0.064, 0.028, 0.026, 0.012), right),
                  placed(finger("finger", 0.064, 0.028, 0.026, 0.012), left),
                  // Only one finger carries a stop.
                  box_part("stop", {0.012, 0.018, 0.022}, {0.051, 0.012, 0.124}, blasted_steel())});
    add(gripper, sensor(frame_at({0.022, 0.051, 0.064})));
    add(gripper, hose_fitting(frame_at({0.040, -0.035, 0.050}, -Vector3d::UnitY())));
    add(gripper, hose_fitting(frame_at({0.060, 0.020, 0.070}, Vector3d::UnitX())));
    gripper.T_tool_grasp = frame_at({0, 0, 0.152});
    gripper.opening_m = kOpening_m;
    return gripper;
}

Gripper three_finger() {
    constexpr double kOpening_m = 0.050;
    Gripper gripper;
    add(gripper, adapter());
    Part palm{"palm", lathe({{0.040, 0.028}, {0.048, 0.034}, {0.048, 0.066}, {0.043, 0.072}}),
              blasted_aluminium()};
    append(palm.mesh, cylinder(0.018, 0.070, 0.078));
    add(gripper, {palm});
    for (int i = 0; i < 3; ++i) {
        const Pose turn = turned_about_z(2.0 * std::numbers::pi * i / 3.0);
        add(gripper,
            {placed(box_part("jaw", {0.034, 0.024, 0.016}, {0.038, 0, 0.078}, blasted_steel()),
                    turn),
             placed(finger("finger", 0.060, 0.018, 0.022, 0.009),
                    turn * frame_at({kOpening_m / 2.0, 0, 0.084}))});
    }
    add(gripper, {box_part("valve", {0.030, 0.040, 0.030}, {-0.052, 0.022, 0.050}, dark_plastic()),
                  box_part("connector", {0.018, 0.014, 0.026}, {0.006, -0.052, 0.048},
                           light_plastic(), 0.001)});
    add(gripper, sensor(frame_at({0.044, 0.040, 0.052})));
    add(gripper, hose_fitting(frame_at({0.040, -0.024, 0.050}, {0.85, -0.53, 0.0})));
    gripper.T_tool_grasp = frame_at({0, 0, 0.126});
    gripper.opening_m = kOpening_m;
    return gripper;
}

Gripper parallel_wide() {
    constexpr double kOpening_m = 0.060;
    Gripper gripper;
    add(gripper, adapter());
    add(gripper,
        {box_part("beam", {0.176, 0.050, 0.036}, {0, 0, 0.046}, blasted_aluminium(), 0.004),
         box_part("cover", {0.090, 0.058, 0.020}, {0.012, 0.002, 0.042}, light_plastic()),
         box_part("motor", {0.052, 0.034, 0.034}, {0.040, 0.040, 0.044}, dark_plastic()),
         box_part("end stop", {0.010, 0.060, 0.046}, {-0.088, 0, 0.046}, blasted_steel())});
    for (const double side : {1.0, -1.0}) {
        const double x = side * kOpening_m / 2.0;
        add(gripper, {box_part("plate", {0.008, 0.052, 0.062}, {x + side * 0.004, 0, 0.100},
                               blasted_steel(), 0.001),
                      box_part("foot", {0.034, 0.036, 0.012}, {x + side * 0.018, 0, 0.068},
                               blasted_aluminium())});
    }
    add(gripper,
        {box_part("rib", {0.020, 0.008, 0.034}, {0.046, 0.010, 0.088}, blasted_steel(), 0.001)});
    add(gripper, hose_fitting(frame_at({-0.050, -0.024, 0.046}, -Vector3d::UnitY())));
    gripper.T_tool_grasp = frame_at({0, 0, 0.112});
    gripper.opening_m = kOpening_m;
    return gripper;
}

/// A suction cup with two bellows, its lip at z = 0.
Part cup(const Vector3d& lip_m) {
    const Mesh mesh = lathe({{0.006, -0.030},
                             {0.006, -0.020},
                             {0.012, -0.018},
                             {0.008, -0.014},
                             {0.013, -0.010},
                             {0.009, -0.006},
                             {0.015, 0.0}});
    Part part{"cup", moved(mesh, frame_at(lip_m)), dark_plastic()};
    part.material.albedo = 0.36;
    return part;
}

Gripper suction() {
    Gripper gripper;
    add(gripper, adapter());
    add(gripper,
        {box_part("column", {0.034, 0.034, 0.042}, {0, 0, 0.048}, blasted_steel(), 0.003),
         box_part("plate", {0.150, 0.090, 0.012}, {0, 0, 0.074}, blasted_aluminium()),
         box_part("ejector", {0.056, 0.024, 0.030}, {0.036, 0.024, 0.054}, light_plastic()),
         box_part("switch", {0.020, 0.030, 0.020}, {-0.040, -0.024, 0.058}, dark_plastic())});
    for (const double x : {-0.034, 0.034}) {
        for (const double y : {-0.021, 0.021}) gripper.parts.push_back(cup({x, y, 0.110}));
    }
    add(gripper, hose_fitting(frame_at({0.062, 0.024, 0.050}, Vector3d::UnitX())));
    add(gripper, hose_fitting(frame_at({-0.055, 0.030, 0.066}, -Vector3d::UnitZ())));
    gripper.T_tool_grasp = frame_at({0, 0, 0.110});
    return gripper;
}

/// Looks the same at every angle: the turn of such a part cannot be observed.
Gripper plain_cylinder() {
    Gripper gripper;
    const Mesh body = lathe({{0.036, 0.0},
                             {0.036, 0.016},
                             {0.028, 0.018},
                             {0.028, 0.030},
                             {0.046, 0.036},
                             {0.046, 0.110},
                             {0.038, 0.118},
                             {0.038, 0.140},
                             {0.020, 0.152}},
                            240);
    gripper.parts = {{"body", body, blasted_aluminium()}};
    gripper.T_tool_grasp = frame_at({0, 0, 0.152});
    return gripper;
}

const std::map<std::string, std::function<Gripper()>>& makers() {
    static const std::map<std::string, std::function<Gripper()>> table = {
        {"two-finger", two_finger},
        {"three-finger", three_finger},
        {"parallel-wide", parallel_wide},
        {"suction", suction},
        {"cylinder", plain_cylinder}};
    return table;
}

}  // namespace

std::vector<std::string> gripper_names() {
    return {"two-finger", "three-finger", "parallel-wide", "suction", "cylinder"};
}

Gripper make_gripper(const std::string& name) {
    const auto maker = makers().find(name);
    return maker == makers().end() ? Gripper{} : maker->second();
}

}  // namespace gripscan::sim
