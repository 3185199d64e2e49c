// Text files of numbers, read line by line in the C locale.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace gripscan {

/// Walks over lines that end with "\n" or "\r\n"; the last one may lack its end.
class LineScanner {
  public:
    explicit LineScanner(std::string_view text) : text_(text) {}

    /// The next line without its end; nothing after the last one.
    std::optional<std::string_view> next();

    /// The next line that is not blank.
    std::optional<std::string_view> next_with_content();

    /// Number of the line that was read last, from 1.
    [[nodiscard]] std::size_t line_number() const { return line_number_; }
    /// Offset of the first byte that was not read yet.
    [[nodiscard]] std::size_t offset() const { return offset_; }

  private:
    std::string_view text_;
    std::size_t offset_ = 0;
    std::size_t line_number_ = 0;
};

/// The words of a line; any of `separators` between them. `words` is reused.
void split_words(std::string_view line, std::string_view separators,
                 std::vector<std::string_view>& words);
inline constexpr std::string_view kBlanks = " \t\r";

/// A number as point files have it: also nan and inf, which numbers of settings must not be.
[[nodiscard]] std::optional<double> value_from_word(std::string_view word);

/// A count: digits only.
[[nodiscard]] std::optional<std::size_t> count_from_word(std::string_view word);

}  // namespace gripscan
