#include "core/session/capture_columns.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"

namespace gripscan {
namespace {

using Problem = std::optional<std::string>;

Problem read_number(std::optional<double>& value, const std::string& cell) {
    value = number_from_text(cell);
    if (value) return {};
    return fmt::format("'{}' is not a finite number (decimal point, no unit)", cell);
}

std::optional<int> whole_number(const std::string& cell) {
    const auto number = number_from_text(cell);
    if (!number || *number != std::floor(*number) || *number < 0.0 || *number > 1e9) return {};
    return static_cast<int>(*number);
}

std::string number_cell(const std::optional<double>& value) {
    return value ? text_from_number(*value) : "";
}

Problem read_path(std::string& path, const std::string& cell) {
    const std::filesystem::path given(cell);
    const std::filesystem::path normal = given.lexically_normal();
    if (given.is_absolute() || normal.empty() || *normal.begin() == "..") {
        return fmt::format("'{}' leaves the session folder; paths are relative to it", cell);
    }
    path = cell;
    return {};
}

Problem read_index(CaptureRow& row, const std::string& cell) {
    const auto index = whole_number(cell);
    if (!index) return fmt::format("'{}' is not a whole number from 0 on", cell);
    row.index = *index;
    return {};
}

Problem read_attempt(CaptureRow& row, const std::string& cell) {
    row.attempt = whole_number(cell);
    if (row.attempt && *row.attempt >= 1) return {};
    return fmt::format("'{}' is not a whole number from 1 on", cell);
}

Problem read_status(CaptureRow& row, const std::string& cell) {
    for (const auto status :
         {CaptureStatus::kUsed, CaptureStatus::kSuperseded, CaptureStatus::kExcluded}) {
        if (cell != word(status)) continue;
        row.status = status;
        return {};
    }
    return fmt::format("'{}' is none of used, superseded, excluded", cell);
}

Problem read_mode(CaptureRow& row, const std::string& cell) {
    for (const auto mode : {TurnMode::kFree, TurnMode::kAxisLocked}) {
        if (cell != word(mode)) continue;
        row.mode = mode;
        return {};
    }
    return fmt::format("'{}' is none of free, axis-locked", cell);
}

std::string mode_cell(const CaptureRow& row) {
    return row.mode == TurnMode::kFree ? "" : std::string(word(row.mode));
}

Problem read_note(CaptureRow& row, const std::string& cell) {
    row.note = cell;
    return {};
}

template <std::size_t kJoint>
constexpr CaptureColumn joint_column(std::string_view name) {
    return {name,
            [](CaptureRow& row, const std::string& cell) {
                return read_number(row.joints_deg[kJoint], cell);
            },
            [](const CaptureRow& row) { return number_cell(row.joints_deg[kJoint]); }};
}

template <std::size_t kPart>
constexpr CaptureColumn tool_column(std::string_view name) {
    return {
        name,
        [](CaptureRow& row, const std::string& cell) { return read_number(row.tool[kPart], cell); },
        [](const CaptureRow& row) { return number_cell(row.tool[kPart]); }};
}

template <std::optional<double> CaptureRow::*kMember>
constexpr CaptureColumn number_column(std::string_view name) {
    return {
        name,
        [](CaptureRow& row, const std::string& cell) { return read_number(row.*kMember, cell); },
        [](const CaptureRow& row) { return number_cell(row.*kMember); }};
}

template <std::string CaptureRow::*kMember>
constexpr CaptureColumn path_column(std::string_view name) {
    return {name,
            [](CaptureRow& row, const std::string& cell) { return read_path(row.*kMember, cell); },
            [](const CaptureRow& row) { return row.*kMember; }};
}

constexpr std::array kColumns{
    CaptureColumn{"index", read_index,
                  [](const CaptureRow& row) { return fmt::format("{}", row.index); }},
    number_column<&CaptureRow::commanded_deg>("commanded_deg"),
    joint_column<0>("j1_deg"),
    joint_column<1>("j2_deg"),
    joint_column<2>("j3_deg"),
    joint_column<3>("j4_deg"),
    joint_column<4>("j5_deg"),
    joint_column<5>("j6_deg"),
    number_column<&CaptureRow::j6_after_deg>("j6_after_deg"),
    tool_column<0>("x_mm"),
    tool_column<1>("y_mm"),
    tool_column<2>("z_mm"),
    tool_column<3>("w_deg"),
    tool_column<4>("p_deg"),
    tool_column<5>("r_deg"),
    path_column<&CaptureRow::left>("left"),
    path_column<&CaptureRow::right>("right"),
    path_column<&CaptureRow::cloud>("cloud"),
    number_column<&CaptureRow::t_s>("t_s"),
    CaptureColumn{
        "attempt", read_attempt,
        [](const CaptureRow& row) { return row.attempt ? fmt::format("{}", *row.attempt) : ""; }},
    CaptureColumn{"status", read_status,
                  [](const CaptureRow& row) { return std::string(word(row.status)); }},
    CaptureColumn{"mode", read_mode, mode_cell},
    CaptureColumn{"note", read_note, [](const CaptureRow& row) { return row.note; }},
};

}  // namespace

std::span<const CaptureColumn> capture_columns() {
    return kColumns;
}

const CaptureColumn* find_capture_column(std::string_view name) {
    const auto found = std::find_if(kColumns.begin(), kColumns.end(),
                                    [&](const CaptureColumn& c) { return c.name == name; });
    return found == kColumns.end() ? nullptr : &*found;
}

}  // namespace gripscan
