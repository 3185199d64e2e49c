// The words of a GSP/1 line: read one after the other, strictly, and numbers as words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gripscan::gsp {

/// Takes words from the front of a line; one or more spaces lie between them.
class WordReader {
  public:
    explicit WordReader(std::string_view line);

    /// Nothing at the end of the line.
    std::optional<std::string_view> word();
    /// A whole number of that range; nothing for anything else.
    std::optional<int> whole(int min, int max);
    std::optional<std::int64_t> whole64();
    /// Digits with at most one decimal point between them, and a minus perhaps; no exponent.
    std::optional<double> number();

    /// The same, or "-" for unknown: nothing if it is malformed, an empty value if unknown.
    template <typename Value, typename... Args>
    std::optional<std::optional<Value>> known(std::optional<Value> (WordReader::*read)(Args...),
                                              Args... args) {
        if (take_dash()) return std::optional<Value>();
        const auto value = (this->*read)(args...);
        if (!value) return std::nullopt;
        return std::optional<std::optional<Value>>(value);
    }

    /// Free text: all that is left, without spaces around it.
    [[nodiscard]] std::string_view rest() const { return left_; }
    [[nodiscard]] bool at_end() const { return left_.empty(); }

  private:
    bool take_dash();

    std::string_view left_;
};

/// "%.4f", never "-0.0000". A number that is none, or too large for a position, is unknown: "-".
[[nodiscard]] std::string fixed_text(double value);
/// The same without zeros at its end: "10", "12.5".
[[nodiscard]] std::string short_text(double value);

[[nodiscard]] std::string word_or_dash(std::optional<double> value);
[[nodiscard]] std::string word_or_dash(std::optional<int> value);
[[nodiscard]] std::string word_or_dash(std::optional<std::int64_t> value);
[[nodiscard]] std::string word_or_dash(std::optional<bool> value);

/// Only the characters from space to '~'?
[[nodiscard]] bool is_printable(std::string_view text);
/// For messages: '?' for anything else, and no longer than 80 characters.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace gripscan::gsp
