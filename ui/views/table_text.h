// Table 1, and the list of all attempts, as words and rounded numbers. Pure; full precision comes
// from core/report/table1.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/table1.h"
#include "ui/theme/state.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

enum class Emphasis { kNormal, kSecond, kThird, kStrong, kCheck, kReject };

struct CellText {
    std::string text = {};
    Emphasis emphasis = Emphasis::kNormal;
    std::optional<State> shape = std::nullopt;  ///< before the words
    std::string note = {};                      ///< after them
    std::optional<double> bar = std::nullopt;   ///< −1 … 1 is the limit
};
struct ColumnText {
    std::string_view title;
    std::string_view group;
    float width_px = 50.0F;  ///< at 100 %
    int drop = 0;            ///< in a narrow window those with the smallest drop > 0 go first
    bool fills = false;
    bool words = false;
};
struct RowText {
    std::vector<CellText> cells;
    std::optional<State> tint = std::nullopt;
};
struct TableText {
    std::span<const ColumnText> columns;
    std::vector<RowText> rows;
    std::vector<RowText> last_rows;  ///< sum, closure
};

enum class TableView { kRobotAgainstIcp, kPose };

[[nodiscard]] TableText table_text(const Snapshot& snapshot, TableView view);
/// Every capture, superseded ones too, in the order they were taken.
[[nodiscard]] TableText attempts_text(const Snapshot& snapshot);

/// Table 1 with every column, as the CSV holds it.
[[nodiscard]] Table1 full_table(const Snapshot& snapshot);
/// The same for the clipboard: columns parted by tabulators, full precision.
[[nodiscard]] std::string table_for_clipboard(const Snapshot& snapshot);

}  // namespace gripscan::ui
