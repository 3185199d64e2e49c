// Inputs of the procedure as entries of a journal, and back. Numbers survive to the last bit.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/procedure/input.h"
#include "core/procedure/journal.h"
#include "core/procedure/turn_plan.h"

namespace gripscan {

struct JournalRecord {
    std::string event;  ///< "command" or "event"; "plan" for the plan
    JournalFields fields;
};

[[nodiscard]] JournalRecord encode(const Input& input);
/// Nothing if the record is not an input. Error: it claims to be one and cannot be read; the
/// message names the field.
[[nodiscard]] Result<std::optional<Input>> decode_input(std::string_view event,
                                                        const JournalFields& entry);

[[nodiscard]] JournalRecord encode(const TurnPlan& plan);
[[nodiscard]] Result<TurnPlan> decode_plan(const JournalFields& entry);

}  // namespace gripscan
