// captures.csv: one line a capture, in the file's units.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/procedure/capture_record.h"

namespace gripscan {

struct CaptureRow {
    int index = 0;
    std::optional<double> commanded_deg;              ///< turn since the first capture
    std::array<std::optional<double>, 6> joints_deg;  ///< read before the exposure, absolute
    std::optional<double> j6_after_deg;               ///< read after it
    std::array<std::optional<double>, 6> tool;        ///< x y z in mm, w p r in deg
    std::string left;  ///< paths relative to the folder; may be empty
    std::string right;
    std::string cloud;
    std::optional<double> t_s;
    std::optional<int> attempt;
    CaptureStatus status = CaptureStatus::kUsed;
    TurnMode mode = TurnMode::kFree;  ///< of the step that leads here: free or axis-locked
    std::string note;                 ///< the operator's, who accepted that step; empty: did not
    std::vector<std::string> other;   ///< cells of the unknown columns, in their order
    int line = 0;                     ///< in the file; 0: not from a file
};

struct CaptureTable {
    std::vector<std::string> columns;  ///< the header as found
    std::vector<CaptureRow> rows;      ///< in order of the file, indices rising
};

/// Header of a new session: every column of the contract, then mode and note.
[[nodiscard]] std::vector<std::string> all_capture_columns();

/// Columns are found by name, unknown ones kept, missing ones empty. Numbers that are none, indices
/// that do not rise, paths that leave the folder: errors with file, line and column.
[[nodiscard]] Result<CaptureTable> parse_capture_table(const std::filesystem::path& path,
                                                       const std::string& text);
/// The columns as found, and those of the contract that have got a value since.
[[nodiscard]] std::string capture_table_text(const CaptureTable& table);

/// The line of a capture whose images lie in frames/; what is not known stays empty.
[[nodiscard]] CaptureRow row_of(const CaptureRecord& capture);

}  // namespace gripscan
