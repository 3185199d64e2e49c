#include "core/procedure/field_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace gripscan {
namespace {

bool is_inside_letter(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// On one line, and not too long for a message.
std::string excerpt(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    std::size_t end = std::min(text.size(), kLongest);
    while (end > 0 && end < text.size() && is_inside_letter(text[end])) --end;
    std::string shown(text.substr(0, end));
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char c) { return c < ' '; }, ' ');
    return end < text.size() ? shown + "…" : shown;
}

}  // namespace

bool FieldReader::has(std::string_view name) const {
    const std::string full = path_.full_name(name);
    return std::any_of(fields_.begin(), fields_.end(), [&](const auto& field) {
        return field.first == full || field.first.starts_with(full + ".");
    });
}

const std::string* FieldReader::find(std::string_view name) const {
    const std::string full = path_.full_name(name);
    const auto found = std::find_if(fields_.begin(), fields_.end(),
                                    [&](const auto& field) { return field.first == full; });
    return found == fields_.end() ? nullptr : &found->second;
}

void FieldReader::fail_missing(std::string_view name) {
    if (!error_) error_ = fmt::format("'{}' is missing", path_.full_name(name));
}

void FieldReader::fail(std::string_view name, std::string_view wanted, std::string_view found) {
    if (error_) return;
    error_ =
        fmt::format("'{}' must be {}, not '{}'", path_.full_name(name), wanted, excerpt(found));
}

}  // namespace gripscan
