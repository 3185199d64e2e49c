#include "ui/panels/text_table.h"

#include <array>

namespace gripscan::ui {
namespace {

Tone tone_of(Emphasis emphasis) {
    constexpr std::array kTones{Tone::kNormal, Tone::kSecond, Tone::kThird,
                                Tone::kStrong, Tone::kCheck,  Tone::kReject};
    return kTones[static_cast<std::size_t>(emphasis)];
}

std::vector<TableRow> rows_of(const std::vector<RowText>& texts) {
    std::vector<TableRow> rows;
    for (const RowText& text : texts) {
        TableRow row;
        row.tint = text.tint;
        for (const CellText& cell : text.cells) {
            row.cells.push_back(
                {cell.text, tone_of(cell.emphasis), cell.shape, cell.note, cell.bar});
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

TableEvent draw_text_table(const Ui& ui, const Rect& rect, std::string_view id,
                           const TableText& text, std::optional<std::size_t> selected,
                           bool follow) {
    std::vector<TableColumn> columns;
    for (const ColumnText& c : text.columns) {
        columns.push_back({c.title, c.group, c.width_px, c.fills, c.words, c.drop});
    }
    const auto rows = rows_of(text.rows);
    const auto last = rows_of(text.last_rows);
    return data_table(ui, rect, {id, columns, rows, last, selected, follow});
}

}  // namespace gripscan::ui
