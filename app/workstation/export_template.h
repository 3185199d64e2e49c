// The template of a turn as a file, as the export dialog wants it.
#pragma once

#include <string>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/procedure/journal.h"
#include "core/registration/turn_report.h"
#include "ui/views/request.h"

namespace gripscan::app {

struct Exported {
    std::filesystem::path file;
    std::size_t points = 0;
    std::uintmax_t bytes = 0;
};

/// For the journal: "export", what was asked for.
[[nodiscard]] JournalFields journal_fields(const ui::ExportWish& wish);
/// "exported", what came of it.
[[nodiscard]] JournalFields journal_fields(const Exported& exported);

/// Read back and compared before it appears. Errors, after which neither the file nor its sidecar
/// is there: no points, no axis for the axis frame, a file that is there already, one that cannot
/// be written, cancelled.
[[nodiscard]] Result<Exported> export_template(const TurnReport& report, const ui::ExportWish& wish,
                                               const Progress& progress, const ForEach& for_each);

}  // namespace gripscan::app
