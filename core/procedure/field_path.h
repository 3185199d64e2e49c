// Names of fields within fields: "before.joints_rad", "items.2.limit".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace gripscan {

template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <typename T>
inline constexpr bool kIsList = false;
template <typename T>
inline constexpr bool kIsList<std::vector<T>> = true;

/// Where a writer or reader of fields stands.
class FieldPath {
  public:
    [[nodiscard]] std::string full_name(std::string_view name) const {
        return prefix_ + std::string(name);
    }

    /// Names in `body` are those of parts of the field `name`.
    template <typename Body>
    void within(std::string_view name, Body&& body) {
        const std::size_t outer = prefix_.size();
        prefix_.append(name).append(".");
        body();
        prefix_.resize(outer);
    }

  private:
    std::string prefix_;
};

}  // namespace gripscan
