#include "ui/views/row_commands.h"

#include <fmt/format.h>

#include "core/procedure/step.h"
#include "ui/views/actions.h"

namespace gripscan::ui {

std::vector<RowCommand> row_commands(const Snapshot& s, std::size_t row) {
    if (s.procedure == nullptr || !s.session) return {};
    const auto table = table_of(*s.procedure);
    if (row >= table.size()) return {};
    const int capture = table[row].row.to;
    const auto why_not = [&](const Command& command) -> std::optional<std::string> {
        if (s.session->recorded) return "a recording is shown: nothing is moved or captured";
        return refusal(*s.procedure, command);
    };
    const command::Retake retake{capture};
    const command::Exclude exclude{capture};
    const Action& accept = action("step.accept");
    const auto why_no_note = row + 1 == table.size()
                                 ? accept.refusal(s)
                                 : std::optional<std::string>("only the last step can be accepted");
    return {
        {"row.retake", fmt::format("Retake capture {}", capture),
         "Turn back to that angle and take the view again", request::Give{retake}, why_not(retake)},
        {"row.exclude", fmt::format("Exclude capture {}", capture),
         "Leave the view out; its neighbours are compared with each other", request::Give{exclude},
         why_not(exclude)},
        {"row.note", "Accept with note…", accept.tooltip, accept.request(s), why_no_note}};
}

}  // namespace gripscan::ui
