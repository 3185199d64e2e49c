// Where a report was written and how the turn came out, as `report --json` prints it.
#pragma once

#include <string>

#include "core/registration/turn_report.h"

namespace gripscan {

[[nodiscard]] std::string report_json(const TurnReport& report, const std::string& csv_path,
                                      const std::string& html_path);

/// Where a template was exported to, as `export --json` prints it.
[[nodiscard]] std::string export_json(const std::string& path, std::size_t points,
                                      std::string_view unit, std::string_view frame);

}  // namespace gripscan
