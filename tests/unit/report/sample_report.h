// A report with everything in it: accepted, doubtful and failed steps, closure, axis, poses.
#pragma once

#include "core/base/units.h"
#include "core/registration/turn_report.h"

namespace gripscan::test {

[[nodiscard]] inline TurnStep sample_step(int index, double robot_deg, double icp_deg) {
    TurnStep step;
    step.index = index;
    step.from = index - 1;
    step.to = index;
    step.commanded_rad = rad_from_deg(10.0);
    step.robot_rad = rad_from_deg(robot_deg);
    step.icp_rad = rad_from_deg(icp_deg);
    step.error_rad = *step.icp_rad - *step.robot_rad;
    step.sigma_rad = rad_from_deg(0.03);
    step.observability = 0.9;
    step.tilt_rad = rad_from_deg(0.2);
    step.axis_offset_m = 0.3e-3;
    step.slip_m = -0.04e-3;
    Pose T = Pose::Identity();
    T.linear() = rotation_from_euler({rad_from_deg(icp_deg), rad_from_deg(-0.5), 1.0 / 3.0});
    T.translation() = Eigen::Vector3d(-0.0156, 0.0932, 0.0277);
    step.T = T;
    step.overlap = 0.83;
    step.rms_m = 0.21e-3;
    step.median_m = 0.15e-3;
    step.p90_m = 0.4e-3;
    step.verdict = Verdict::kAccept;
    step.sentence = "agrees with the robot";
    return step;
}

/// Step 2 is to be checked, step 3 rejected without a pose.
[[nodiscard]] inline TurnReport sample_report() {
    TurnReport report;
    report.sign_source = SignSource::kJoint;
    report.steps = {sample_step(1, 9.998, 9.98), sample_step(2, 10.0, 10.7)};
    report.steps[1].verdict = Verdict::kCheck;
    report.steps[1].cause = Cause::kMislabelled;
    report.steps[1].sentence = "error +0.700 deg, limit 0.500 deg";
    TurnStep lost;
    lost.index = 3;
    lost.from = 2;
    lost.to = 4;
    lost.attempts = 2;
    lost.commanded_rad = rad_from_deg(20.0);
    lost.verdict = Verdict::kReject;
    lost.cause = Cause::kNotConverged;
    lost.sentence = "no alignment of <the two> clouds & nothing else";
    report.steps.push_back(lost);
    report.axis = AxisEstimate{{{0.02, 0.01, 0.74}, Eigen::Vector3d(0.6, 0.0, 0.8)}, 1e-4, 2e-5};
    report.closure_before = Closure{0.01, 1.2e-3};
    report.closure_after = Closure{0.001, 0.1e-3};
    report.poses = {Pose::Identity(), report.steps[0].T->inverse(), std::nullopt, std::nullopt};
    report.merged.points = {{0.f, 0.f, 1.f}, {0.1f, 0.f, 1.f}};
    return report;
}

}  // namespace gripscan::test
