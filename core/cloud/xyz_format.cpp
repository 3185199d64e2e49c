#include "core/cloud/xyz_format.h"

#include <cmath>

#include "core/cloud/number_writer.h"
#include "core/cloud/text_scan.h"

namespace gripscan {
namespace {

constexpr std::string_view kSeparators = " \t\r,;";
constexpr std::size_t kMaxColumns = 64;

using Words = std::vector<std::string_view>;

/// The columns a comment line names; empty if it is an ordinary comment.
std::vector<std::string> names_in_comment(const Words& words) {
    if (words.size() < 4 || words[0] != "#" || words[1] != "x" || words[2] != "y" ||
        words[3] != "z") {
        return {};
    }
    return {words.begin() + 1, words.end()};
}

PointTable table_with(const std::vector<std::string>& names) {
    PointTable table;
    for (const std::string& name : names) {
        table.columns.push_back({std::string(known_column(name)), {}});
    }
    return table;
}

Status append_row(const Words& words, PointTable& table) {
    if (words.size() != table.columns.size()) {
        return input_error("{} numbers instead of {}", words.size(), table.columns.size());
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto value = value_from_word(words[i]);
        if (!value) return input_error("'{}' is no number", words[i].substr(0, 40));
        if (!table.columns[i].name.empty()) table.columns[i].values.push_back(*value);
    }
    ++table.rows;
    return {};
}

/// Without names only the first three columns are known.
Status start_unnamed(const Words& words, PointTable& table) {
    if (words.size() < 3 || words.size() > kMaxColumns) {
        return input_error("{} words; a point has three numbers x y z", words.size());
    }
    std::vector<std::string> names{"x", "y", "z"};
    names.resize(words.size());
    table = table_with(names);
    return {};
}

}  // namespace

Result<PointTable> decode_xyz(std::string_view bytes) {
    PointTable table;
    LineScanner lines(bytes);
    Words words;
    while (const auto line = lines.next_with_content()) {
        split_words(*line, kSeparators, words);
        if (words.empty()) continue;
        if (words[0].starts_with('#') || words[0].starts_with("//")) {
            const auto names = names_in_comment(words);
            if (table.rows == 0 && !names.empty()) table = table_with(names);
            continue;
        }
        Status status;
        if (table.columns.empty()) status = start_unnamed(words, table);
        if (status) status = append_row(words, table);
        if (!status) {
            return input_error("line {}: {}", lines.line_number(), status.error().message);
        }
    }
    if (table.columns.empty()) return input_error("there are no points in it");
    std::erase_if(table.columns, [](const auto& column) { return column.name.empty(); });
    return table;
}

std::string encode_xyz(const PointTable& table) {
    std::string text = "#";
    for (const auto& column : table.columns) text += ' ' + column.name;
    text += '\n';
    for (std::size_t row = 0; row < table.rows; ++row) {
        const bool empty_cell =
            table.grid_width > 0 && !std::isfinite(table.columns[0].values[row]);
        if (!empty_cell) append_text_row(text, table, row);
    }
    return text;
}

}  // namespace gripscan
