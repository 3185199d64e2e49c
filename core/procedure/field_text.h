// One value of a journal entry as text, and back to the same bits.
#pragma once

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "core/geometry/pose.h"
#include "core/procedure/field_words.h"

namespace gripscan {

/// Whole numbers, but no truth values.
template <typename T>
concept WholeNumber = std::integral<T> && !std::same_as<T, bool>;

[[nodiscard]] std::string field_text(double value);
[[nodiscard]] std::string field_text(bool value);  ///< "true", "false"
[[nodiscard]] inline std::string field_text(const std::string& value) {
    return value;
}
[[nodiscard]] std::string field_text(const std::array<double, 6>& values);
[[nodiscard]] std::string field_text(const Eigen::Vector3d& values);
[[nodiscard]] std::string field_text(const Pose& T);  ///< 16 numbers, row-major

template <WholeNumber T>
[[nodiscard]] std::string field_text(T value) {
    return std::to_string(value);
}

template <typename Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] std::string field_text(Enum value) {
    return std::string(word(value));
}

/// What was wanted where a text cannot be read, such as "a number"; nothing: `value` was set.
using Wanted = std::optional<std::string_view>;

[[nodiscard]] Wanted read_field(const std::string& text, double& value);
[[nodiscard]] Wanted read_field(const std::string& text, bool& value);
[[nodiscard]] Wanted read_field(const std::string& text, int& value);
[[nodiscard]] Wanted read_field(const std::string& text, std::size_t& value);
[[nodiscard]] Wanted read_field(const std::string& text, std::string& value);
[[nodiscard]] Wanted read_field(const std::string& text, std::array<double, 6>& values);
[[nodiscard]] Wanted read_field(const std::string& text, Eigen::Vector3d& values);
/// The numbers must be a rigid motion to 1e-6 and are then taken as they stand.
[[nodiscard]] Wanted read_field(const std::string& text, Pose& T);

template <typename Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] Wanted read_field(const std::string& text, Enum& value) {
    const auto known = value_of_word<Enum>(text);
    if (!known) return "a word of this version";
    value = *known;
    return std::nullopt;
}

}  // namespace gripscan
