#include "core/cloud/text_scan.h"

#include <charconv>

namespace gripscan {
namespace {

template <typename T>
std::optional<T> whole_word_as(std::string_view word) {
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

}  // namespace

std::optional<std::string_view> LineScanner::next() {
    if (offset_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
    std::string_view line = text_.substr(offset_, end - offset_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    offset_ = std::min(end + 1, text_.size());
    ++line_number_;
    return line;
}

std::optional<std::string_view> LineScanner::next_with_content() {
    auto line = next();
    while (line && line->find_first_not_of(kBlanks) == std::string_view::npos) line = next();
    return line;
}

void split_words(std::string_view line, std::string_view separators,
                 std::vector<std::string_view>& words) {
    words.clear();
    std::size_t begin = line.find_first_not_of(separators);
    while (begin != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(separators, end);
    }
}

std::optional<double> value_from_word(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    return whole_word_as<double>(word);
}

std::optional<std::size_t> count_from_word(std::string_view word) {
    return whole_word_as<std::size_t>(word);
}

}  // namespace gripscan
