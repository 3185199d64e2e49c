#include "app/workstation/region_in_cell_file.h"

#include <cmath>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/session/cell_file.h"
#include "core/session/yaml_parts.h"

namespace gripscan::app {
namespace {

/// To a tenth of a millimetre: what is shown is what is kept.
double rounded_m(double value_m) {
    constexpr double kPerMetre = 1e4;
    return std::round(value_m * kPerMetre) / kPerMetre;
}

Box rounded(const Box& region) {
    return {region.min_m.unaryExpr(&rounded_m), region.max_m.unaryExpr(&rounded_m)};
}

/// A comment behind a value, with the blanks before it; empty: none.
std::string_view comment_of(std::string_view line) {
    const std::size_t hash = line.find(" #");
    if (hash == std::string_view::npos) return {};
    const std::size_t words = line.find_last_not_of(' ', hash);
    return words == std::string_view::npos ? std::string_view() : line.substr(words + 1);
}

/// Belongs to the key above: deeper, or the closing of its brackets.
bool continues(std::string_view line) {
    return !line.empty() && (line[0] == ' ' || line[0] == '\t' || line[0] == '}' || line[0] == ']');
}

}  // namespace

std::string with_region(std::string_view cell_file, const Box& region) {
    std::string line_of_region = region_line(rounded(region));
    line_of_region.pop_back();  // its end of line
    std::string text;
    bool inside = false;
    bool written = false;
    while (!cell_file.empty()) {
        const std::size_t end = cell_file.find('\n');
        const std::string_view line = cell_file.substr(0, end);
        cell_file.remove_prefix(end == std::string_view::npos ? cell_file.size() : end + 1);
        inside = inside && continues(line);
        if (inside) continue;
        if (line.starts_with("region:")) {
            inside = true;
            written = true;
            text += line_of_region;
            text += comment_of(line);
        } else {
            text += line;
        }
        text += '\n';
    }
    if (!written) text += line_of_region + "\n";
    return text;
}

Status keep_region(const std::filesystem::path& cell_file, const Box& region) {
    const auto before = read_whole_file(cell_file);
    if (!before) return forward_error(before.error());
    const std::string text = with_region(*before, region);
    return write_file_atomically(cell_file, [&](const std::filesystem::path& temporary) -> Status {
        std::ofstream file(temporary, std::ios::binary);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.close();
        if (!file) return input_error("{} could not be written", temporary.string());
        const auto read = load_cell_file(temporary);
        if (!read) return forward_error(read.error());
        const Box wanted = rounded(region);
        if (!read->region || !read->region->min_m.isApprox(wanted.min_m) ||
            !read->region->max_m.isApprox(wanted.max_m)) {
            return input_error("{} would not read back with that area", cell_file.string());
        }
        return {};
    });
}

}  // namespace gripscan::app
