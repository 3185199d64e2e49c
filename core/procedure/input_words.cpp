#include "core/procedure/input_words.h"

namespace gripscan {
namespace {

// to_array() counts: a variant with another number of alternatives does not compile.
constexpr WordsOf<Command> kCommands = std::to_array<std::string_view>(
    {"connect",    "check_cell", "warm_up", "capture", "step",   "retry",   "halve",
     "lock_axis",  "accept",     "back",    "undo",    "redo",   "exclude", "retake",
     "tell_angle", "run",        "pause",   "stop",    "resume", "finish",
     "set_plan"});

constexpr WordsOf<Event> kEvents = std::to_array<std::string_view>(
    {"link_up", "link_down", "cell_checked", "arrived", "turn_failed", "turn_logged", "exposed",
     "exposure_failed", "judged", "axis_found", "solved", "work_failed", "program_ended"});

}  // namespace

template <>
const WordsOf<Command>& input_words<Command>() {
    return kCommands;
}

template <>
const WordsOf<Event>& input_words<Event>() {
    return kEvents;
}

std::string_view word(const Command& command) {
    return kCommands[command.index()];
}

std::string_view word(const Event& event) {
    return kEvents[event.index()];
}

}  // namespace gripscan
