// Numbers of a point table as bytes and as text. The types are those of Cloud: counts are 16-bit,
// all else is single precision, so that a file reads back to the very same numbers.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "core/cloud/point_table.h"

namespace gripscan {

/// The machines we build for are little-endian.
template <typename T>
void append_little_endian(std::string& bytes, T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
}

inline void append_binary(std::string& bytes, std::string_view column, double value) {
    if (is_count_column(column)) {
        append_little_endian(bytes, static_cast<std::uint16_t>(value));
    } else {
        append_little_endian(bytes, static_cast<float>(value));
    }
}

/// Shortest text that reads back to the same float.
void append_text(std::string& text, double value);

/// One row with blanks between the numbers and a line end.
void append_text_row(std::string& text, const PointTable& table, std::size_t row);

}  // namespace gripscan
