#include "core/cloud/number_writer.h"

#include <array>
#include <charconv>
#include <cmath>

namespace gripscan {

void append_text(std::string& text, double value) {
    if (std::isnan(value)) {
        text += "nan";  // whatever its sign: other readers know no "-nan"
        return;
    }
    std::array<char, 24> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), static_cast<float>(value)).ptr;
    text.append(buffer.data(), end);
}

void append_text_row(std::string& text, const PointTable& table, std::size_t row) {
    const char* separator = "";
    for (const auto& column : table.columns) {
        text += separator;
        append_text(text, column.values[row]);
        separator = " ";
    }
    text += '\n';
}

}  // namespace gripscan
