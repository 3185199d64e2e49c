// What commands and events consist of in a journal, besides their word; see record_fields.h.
#pragma once

#include "core/procedure/input.h"
#include "core/procedure/step_fields.h"

namespace gripscan {

/// Those that say all by their word.
template <typename T>
requires std::is_empty_v<T>
void fields(auto&, T&) {}

void fields(auto& io, Is<command::Accept> auto& accept) {
    auto& [note] = accept;
    io("note", note);
}

void fields(auto& io, Is<command::Exclude> auto& exclude) {
    auto& [index] = exclude;
    io("index", index);
}

void fields(auto& io, Is<command::Retake> auto& retake) {
    auto& [index] = retake;
    io("index", index);
}

void fields(auto& io, Is<command::TellAngle> auto& told) {
    auto& [joint6_rad] = told;
    io("joint6_rad", joint6_rad);
}

void fields(auto& io, Is<command::SetPlan> auto& set) {
    auto& [plan] = set;
    io("plan", plan);
}

void fields(auto& io, Is<event::LinkUp> auto& up) {
    auto& [identity, controller, reading] = up;
    io("identity", identity);
    io("controller", controller);
    io("reading", reading);
}

void fields(auto& io, Is<event::LinkDown> auto& down) {
    auto& [why] = down;
    io("why", why);
}

void fields(auto& io, Is<event::CellChecked> auto& checked) {
    auto& [report] = checked;
    fields(io, report);
}

void fields(auto& io, Is<event::Arrived> auto& arrived) {
    auto& [reading] = arrived;
    fields(io, reading);
}

void fields(auto& io, Is<event::TurnFailed> auto& failed) {
    auto& [fault, last_id, why] = failed;
    io("fault", fault);
    io("last_id", last_id);
    io("why", why);
}

void fields(auto& io, Is<event::Exposed> auto& exposed) {
    auto& [record] = exposed;
    fields(io, record);
}

void fields(auto& io, Is<event::ExposureFailed> auto& failed) {
    auto& [why] = failed;
    io("why", why);
}

void fields(auto& io, Is<event::Judged> auto& judged) {
    auto& [step] = judged;
    fields(io, step);
}

void fields(auto& io, Is<event::AxisFound> auto& found) {
    auto& [axis, sentence, cell, why_none] = found;
    io("axis", axis);
    io("sentence", sentence);
    io("cell", cell);
    io("why_none", why_none);
}

void fields(auto& io, Is<event::Solved> auto& solved) {
    auto& [accepted, steps, template_points] = solved;
    io("accepted", accepted);
    io("steps", steps);
    io("template_points", template_points);
}

void fields(auto& io, Is<event::WorkFailed> auto& failed) {
    auto& [why] = failed;
    io("why", why);
}

}  // namespace gripscan
