// What a judged step and an axis consist of in a journal; see record_fields.h.
#pragma once

#include "core/procedure/judged_step.h"
#include "core/procedure/record_fields.h"

namespace gripscan {

void fields(auto& io, Is<GripSlip> auto& slip) {
    auto& [shift_m, angle_rad, sigma_shift_m, sigma_angle_rad] = slip;
    io("shift_m", shift_m);
    io("angle_rad", angle_rad);
    io("sigma_shift_m", sigma_shift_m);
    io("sigma_angle_rad", sigma_angle_rad);
}

void fields(auto& io, Is<TurnStep> auto& step) {
    auto& [index, from, to, attempts, commanded_rad, robot_rad, icp_rad, error_rad, sigma_rad,
           observability, mode, independent, tilt_rad, axis_offset_m, slip_m, T, overlap, rms_m,
           median_m, p90_m, verdict, cause, sentence, grip_slip] = step;
    io("index", index);
    io("from", from);
    io("to", to);
    io("attempts", attempts);
    io("commanded_rad", commanded_rad);
    io("robot_rad", robot_rad);
    io("icp_rad", icp_rad);
    io("error_rad", error_rad);
    io("sigma_rad", sigma_rad);
    io("observability", observability);
    io("mode", mode);
    io("independent", independent);
    io("tilt_rad", tilt_rad);
    io("axis_offset_m", axis_offset_m);
    io("slip_m", slip_m);
    io("T", T);
    io("overlap", overlap);
    io("rms_m", rms_m);
    io("median_m", median_m);
    io("p90_m", p90_m);
    io("verdict", verdict);
    io("cause", cause);
    io("sentence", sentence);
    io("grip_slip", grip_slip);
}

void fields(auto& io, Is<ForeignObject> auto& object) {
    auto& [centre_m, area_mm2] = object;
    io("centre_m", centre_m);
    io("area_mm2", area_mm2);
}

void fields(auto& io, Is<JudgedStep> auto& judged) {
    auto& [row, foreign, evidence] = judged;
    fields(io, row);
    io("foreign", foreign);
    io("evidence", evidence);
}

void fields(auto& io, Is<Axis> auto& axis) {
    auto& [point_m, direction] = axis;
    io("point_m", point_m);
    io("direction", direction);
}

void fields(auto& io, Is<AxisEstimate> auto& estimate) {
    auto& [axis, sd_rad, sd_m] = estimate;
    fields(io, axis);
    io("sd_rad", sd_rad);
    io("sd_m", sd_m);
}

}  // namespace gripscan
