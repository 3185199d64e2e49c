// What readings, captures, checks and plans consist of in a journal. The names are a file format
// (docs/journal.md). The bindings name every member: one more in a type does not compile here.
#pragma once

#include <concepts>
#include <type_traits>

#include "core/procedure/capture_record.h"
#include "core/procedure/cell_report.h"
#include "core/procedure/turn_plan.h"
#include "core/robot/robot_link.h"

namespace gripscan {

/// U, constant where it is written, not where it is read.
template <typename T, typename U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

void fields(auto& io, Is<RobotReading> auto& reading) {
    auto& [joints_rad, T_world_tool] = reading;
    io("joints_rad", joints_rad);
    io("T_world_tool", T_world_tool);
}

void fields(auto& io, Is<RobotIdentity> auto& identity) {
    auto& [model, axes, protocol] = identity;
    io("model", model);
    io("axes", axes);
    io("protocol", protocol);
}

void fields(auto& io, Is<ControllerState> auto& state) {
    auto& [automatic, servo_on, emergency_stop, fault, moving, override_percent, alarm] = state;
    io("automatic", automatic);
    io("servo_on", servo_on);
    io("emergency_stop", emergency_stop);
    io("fault", fault);
    io("moving", moving);
    io("override_percent", override_percent);
    io("alarm", alarm);
}

void fields(auto& io, Is<CaptureRecord> auto& record) {
    auto& [index, attempt, commanded_rad, status, mode, note, before, joint6_after_rad, t_s] =
        record;
    io("index", index);
    io("attempt", attempt);
    io("commanded_rad", commanded_rad);
    io("status", status);
    io("mode", mode);
    io("note", note);
    io("before", before);
    io("joint6_after_rad", joint6_after_rad);
    io("t_s", t_s);
}

void fields(auto& io, Is<CellCheckItem> auto& item) {
    auto& [name, outcome, value, limit, unit, sentence] = item;
    io("name", name);
    io("outcome", outcome);
    io("value", value);
    io("limit", limit);
    io("unit", unit);
    io("sentence", sentence);
}

void fields(auto& io, Is<CellReport> auto& report) {
    auto& [items] = report;
    io("items", items);
}

void fields(auto& io, Is<TurnLimits> auto& limits) {
    auto& [angle_rad, sigmas, overlap, slip_m, tilt_rad] = limits;
    io("angle_rad", angle_rad);
    io("sigmas", sigmas);
    io("overlap", overlap);
    io("slip_m", slip_m);
    io("tilt_rad", tilt_rad);
}

void fields(auto& io, Is<TurnPlan> auto& plan) {
    auto& [mode, step_rad, total_rad, start_joint6_rad, speed_percent, approach_rad,
           largest_move_rad, warm_up_step_rad, warm_up_shots, warm_up_in_place, limits,
           least_step_rad, retakes_an_angle, halvings_a_turn, rejected_in_a_row] = plan;
    io("mode", mode);
    io("step_rad", step_rad);
    io("total_rad", total_rad);
    io("start_joint6_rad", start_joint6_rad);
    io("speed_percent", speed_percent);
    io("approach_rad", approach_rad);
    io("largest_move_rad", largest_move_rad);
    io("warm_up_step_rad", warm_up_step_rad);
    io("warm_up_shots", warm_up_shots);
    io("warm_up_in_place", warm_up_in_place);
    io("limits", limits);
    io("least_step_rad", least_step_rad);
    io("retakes_an_angle", retakes_an_angle);
    io("halvings_a_turn", halvings_a_turn);
    io("rejected_in_a_row", rejected_in_a_row);
}

}  // namespace gripscan
