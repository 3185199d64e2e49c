// The template of a turn as a file, as the export dialog wants it.
#pragma once

#include <string>

#include "core/base/for_each.h"
#include "core/registration/turn_report.h"
#include "ui/views/request.h"

namespace gripscan::app {

struct Exported {
    std::filesystem::path file;
    std::size_t points = 0;
    std::uintmax_t bytes = 0;
};

/// Read back and compared before it appears. Errors: no points, no axis for the axis frame, a file
/// that is there already, one that cannot be written.
[[nodiscard]] Result<Exported> export_template(const TurnReport& report, const ui::ExportWish& wish,
                                               const ForEach& for_each);

}  // namespace gripscan::app
