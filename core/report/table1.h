// Table 1 without a widget: columns and rows of values, from which CSV, terminal and page are made,
// so that the same number stands everywhere.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/registration/turn_report.h"
#include "core/session/capture_table.h"

namespace gripscan {

/// Nothing where it is not known.
using Table1Cell = std::variant<std::monostate, double, std::string>;

struct Table1Column {
    std::string_view name;   ///< in the CSV, with the unit as suffix
    std::string_view title;  ///< on screen; empty: in the CSV only
    std::string_view unit;   ///< on screen
    int decimals = 0;        ///< on screen
    double scale = 1.0;      ///< on screen the value times this (0.83 → 83 %)
};

enum class Table1RowKind { kStep, kSum, kClosureBefore, kClosureAfter };
[[nodiscard]] std::string_view word(Table1RowKind kind);

struct Table1Row {
    Table1RowKind kind = Table1RowKind::kStep;
    Verdict verdict = Verdict::kAccept;  ///< of a step
    std::vector<Table1Cell> cells;       ///< one per column
};

/// One row a step, then the sum, then closure before and after the joint solution where it is known
/// (angle as error_deg, shift of the axis as axis_offset_mm). A sum with an unknown part is
/// unknown.
struct Table1 {
    std::vector<Table1Column> columns;
    std::vector<Table1Row> rows;
};

/// `captures` adds what only the session knows (times, joint before and after the exposure).
[[nodiscard]] Table1 table1_of(const TurnReport& report, const CaptureTable& captures);

/// Full precision, every column, C locale.
[[nodiscard]] std::string table1_csv(const Table1& table);

/// A cell as it is shown: rounded, empty where unknown.
[[nodiscard]] std::string shown(const Table1Column& column, const Table1Cell& cell);

/// The figures that sum a turn up.
struct TurnSummary {
    std::size_t steps = 0;
    std::size_t accepted = 0;  ///< accept and accept_noted
    std::size_t checks = 0;
    std::size_t rejected = 0;
    std::size_t locked = 0;    ///< whose angle is the robot's, repeated
    std::size_t compared = 0;  ///< steps whose error is known: all but those locked to the axis
    double mean_abs_error_rad = 0.0;
    double worst_abs_error_rad = 0.0;
};
[[nodiscard]] TurnSummary summary_of(const TurnReport& report);

}  // namespace gripscan
