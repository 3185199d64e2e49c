#include "core/robot/gsp_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gripscan::gsp {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Digits, or digits, a point, digits; a minus before them.
bool is_plain_number(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    if (text.empty() || text.size() > 20 || !is_digit(text.front()) || !is_digit(text.back())) {
        return false;
    }
    return std::count(text.begin(), text.end(), '.') <= 1 &&
           std::all_of(text.begin(), text.end(), [](char c) { return is_digit(c) || c == '.'; });
}

template <typename Number>
std::optional<Number> number_of(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string_view without_blanks(std::string_view text) {
    const auto first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

WordReader::WordReader(std::string_view line) : left_(without_blanks(line)) {}

std::optional<std::string_view> WordReader::word() {
    if (left_.empty()) return std::nullopt;
    const std::string_view word = left_.substr(0, left_.find(' '));
    left_ = without_blanks(left_.substr(word.size()));
    return word;
}

std::optional<int> WordReader::whole(int min, int max) {
    const auto text = word();
    const auto value = text ? number_of<int>(*text) : std::nullopt;
    if (!value || *value < min || *value > max) return std::nullopt;
    return value;
}

std::optional<std::int64_t> WordReader::whole64() {
    const auto text = word();
    return text ? number_of<std::int64_t>(*text) : std::nullopt;
}

std::optional<double> WordReader::number() {
    const auto text = word();
    return text && is_plain_number(*text) ? number_of<double>(*text) : std::nullopt;
}

bool WordReader::take_dash() {
    if (left_ != "-" && !left_.starts_with("- ")) return false;
    left_ = without_blanks(left_.substr(1));
    return true;
}

std::string fixed_text(double value) {
    constexpr double kLargest = 1e5;  // so that a line of twelve is never too long
    if (!(std::abs(value) < kLargest)) return "-";
    std::string text = fmt::format("{:.4f}", value);
    if (text == "-0.0000") text.erase(0, 1);
    return text;
}

std::string short_text(double value) {
    std::string text = fixed_text(value);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string word_or_dash(std::optional<double> value) {
    return value ? fixed_text(*value) : "-";
}
std::string word_or_dash(std::optional<int> value) {
    return value ? fmt::format("{}", *value) : "-";
}
std::string word_or_dash(std::optional<std::int64_t> value) {
    return value ? fmt::format("{}", *value) : "-";
}
std::string word_or_dash(std::optional<bool> value) {
    return value ? (*value ? "1" : "0") : "-";
}

bool is_printable(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

std::string printable(std::string_view text) {
    constexpr std::size_t kLongest = 80;
    std::string result(text.substr(0, kLongest));
    std::replace_if(
        result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text.size() > kLongest ? result + "…" : result;
}

}  // namespace gripscan::gsp
