#include "core/session/capture_table.h"

#include <algorithm>
#include <set>

#include "core/session/capture_columns.h"
#include "core/session/csv_text.h"

namespace gripscan {
namespace {

Result<std::vector<std::string>> read_header(const std::string& file, const CsvLine& line) {
    std::vector<std::string> names;
    std::set<std::string> seen;
    for (const auto& cell : line.cells) {
        names.push_back(trimmed(cell));
        if (!names.back().empty() && !seen.insert(names.back()).second) {
            return input_error("{}:{}: column '{}' is given twice", file, line.line, names.back());
        }
    }
    if (!seen.contains("index")) {
        return input_error(
            "{}:{}: no column 'index'; the first line names the columns, separated "
            "by commas",
            file, line.line);
    }
    return names;
}

Result<CaptureRow> read_row(const std::string& file, const std::vector<std::string>& columns,
                            const CsvLine& line) {
    if (line.cells.size() != columns.size()) {
        return input_error("{}:{}: {} cells, but the header names {} columns", file, line.line,
                           line.cells.size(), columns.size());
    }
    CaptureRow row;
    row.line = line.line;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const CaptureColumn* column = find_capture_column(columns[i]);
        if (column == nullptr) {
            row.other.push_back(line.cells[i]);
            continue;
        }
        const std::string cell = trimmed(line.cells[i]);
        if (cell.empty() && column->name == "index") {
            return input_error("{}:{}: column 'index' is empty", file, line.line);
        }
        if (cell.empty()) continue;
        if (const auto problem = column->read(row, cell)) {
            return input_error("{}:{}: column '{}': {}", file, line.line, columns[i], *problem);
        }
    }
    return row;
}

}  // namespace

std::vector<std::string> all_capture_columns() {
    std::vector<std::string> names;
    for (const auto& column : capture_columns()) names.emplace_back(column.name);
    return names;
}

Result<CaptureTable> parse_capture_table(const std::filesystem::path& path,
                                         const std::string& text) {
    const std::string file = path.string();
    const auto lines = parse_csv(file, text);
    if (!lines) return forward_error(lines.error());
    if (lines->empty()) return input_error("{}: the file is empty", file);
    auto header = read_header(file, lines->front());
    if (!header) return forward_error(header.error());
    CaptureTable table;
    table.columns = std::move(*header);
    for (std::size_t i = 1; i < lines->size(); ++i) {
        auto row = read_row(file, table.columns, (*lines)[i]);
        if (!row) return forward_error(row.error());
        if (!table.rows.empty() && row->index <= table.rows.back().index) {
            return input_error("{}:{}: index {} does not rise above {} of the line before", file,
                               row->line, row->index, table.rows.back().index);
        }
        table.rows.push_back(std::move(*row));
    }
    return table;
}

std::string capture_table_text(const CaptureTable& table) {
    std::vector<std::string> columns = table.columns;
    for (const auto& column : capture_columns()) {
        const std::string name(column.name);
        if (std::find(columns.begin(), columns.end(), name) != columns.end()) continue;
        const std::string nothing = column.write(CaptureRow{});
        if (std::any_of(table.rows.begin(), table.rows.end(),
                        [&](const CaptureRow& row) { return column.write(row) != nothing; })) {
            columns.push_back(name);
        }
    }
    std::string text = csv_line(columns);
    for (const auto& row : table.rows) {
        std::vector<std::string> cells;
        std::size_t other = 0;
        for (const auto& name : columns) {
            const CaptureColumn* column = find_capture_column(name);
            if (column != nullptr) {
                cells.push_back(column->write(row));
            } else {
                cells.push_back(other < row.other.size() ? row.other[other] : "");
                ++other;
            }
        }
        text += csv_line(cells);
    }
    return text;
}

}  // namespace gripscan
