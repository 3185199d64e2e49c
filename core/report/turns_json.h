// gripscan-turns/1: the result of a turn as JSON, as `--json` prints it and turns.json keeps it.
// Every step also carries its sentence and the median and 90 % of the residuals, and the document
// the estimated angle scale, steps of a held object its slip in the gripper: additions to the
// format, which readers may leave aside.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/registration/turn_report.h"

namespace gripscan {

struct TemplateReference {
    std::string path;  ///< as it shall stand in the document
    std::size_t points = 0;
};

/// Full precision, fields in the order of the format, null where a number is not known.
[[nodiscard]] std::string turns_json(const TurnReport& report, const TemplateReference& merged);

struct TurnsDocument {
    TurnReport report;  ///< without the points of the template
    TemplateReference merged;
};
/// `path` is for messages.
[[nodiscard]] Result<TurnsDocument> parse_turns_json(const std::filesystem::path& path,
                                                     const std::string& text);

}  // namespace gripscan
