#include "core/procedure/field_text.h"

#include <charconv>
#include <span>

#include "core/base/number_text.h"

namespace gripscan {
namespace {

std::string numbers_text(std::span<const double> values) {
    std::string text;
    for (const double value : values) {
        if (!text.empty()) text += ' ';
        text += text_from_number(value);
    }
    return text;
}

/// As many numbers as there is room, with one blank between two.
bool read_numbers(std::string_view text, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto blank = text.find(' ');
        if ((blank == std::string_view::npos) != (i + 1 == values.size())) return false;
        const auto value = number_from_text(text.substr(0, blank));
        if (!value) return false;
        values[i] = *value;
        text.remove_prefix(blank == std::string_view::npos ? text.size() : blank + 1);
    }
    return true;
}

template <WholeNumber T>
Wanted read_whole(const std::string& text, T& value) {
    T read = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, read);
    if (error != std::errc{} || stopped != end) return "a whole number";
    value = read;
    return std::nullopt;
}

}  // namespace

std::string field_text(double value) {
    return text_from_number(value);
}

std::string field_text(bool value) {
    return value ? "true" : "false";
}

std::string field_text(const std::array<double, 6>& values) {
    return numbers_text(values);
}

std::string field_text(const Eigen::Vector3d& values) {
    return numbers_text({values.data(), 3});
}

std::string field_text(const Pose& T) {
    return numbers_text(row_major_from_pose(T));
}

Wanted read_field(const std::string& text, double& value) {
    const auto number = number_from_text(text);
    if (!number) return "a finite number";
    value = *number;
    return std::nullopt;
}

Wanted read_field(const std::string& text, bool& value) {
    if (text != "true" && text != "false") return "true or false";
    value = text == "true";
    return std::nullopt;
}

Wanted read_field(const std::string& text, int& value) {
    return read_whole(text, value);
}

Wanted read_field(const std::string& text, std::size_t& value) {
    return read_whole(text, value);
}

Wanted read_field(const std::string& text, std::string& value) {
    value = text;
    return std::nullopt;
}

Wanted read_field(const std::string& text, std::array<double, 6>& values) {
    if (!read_numbers(text, values)) return "6 finite numbers";
    return std::nullopt;
}

Wanted read_field(const std::string& text, Eigen::Vector3d& values) {
    if (!read_numbers(text, {values.data(), 3})) return "3 finite numbers";
    return std::nullopt;
}

Wanted read_field(const std::string& text, Pose& T) {
    std::array<double, 16> numbers{};
    if (!read_numbers(text, numbers)) return "16 finite numbers";
    if (!pose_from_row_major(numbers)) return "a rigid motion";
    // As they stand: making them orthonormal again would change the last digits.
    T.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
    return std::nullopt;
}

}  // namespace gripscan
