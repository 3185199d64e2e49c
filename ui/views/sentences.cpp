#include "ui/views/sentences.h"

#include <cctype>

namespace gripscan::ui {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Length of the number that begins at `at`; 0: none begins there.
std::size_t number_length(std::string_view text, std::size_t at) {
    if (at > 0 && (is_letter(text[at - 1]) || is_digit(text[at - 1]) || text[at - 1] == '.' ||
                   text[at - 1] == '_')) {
        return 0;
    }
    std::size_t end = at;
    if (text[end] == '-' || text[end] == '+') ++end;
    const std::size_t first_digit = end;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end == first_digit) return 0;
    if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) {
        ++end;
        while (end < text.size() && is_digit(text[end])) ++end;
    }
    const bool goes_on =
        end < text.size() &&
        (is_letter(text[end]) || text[end] == '_' ||
         (text[end] == '.' && end + 1 < text.size() && !std::isspace(text[end + 1])));
    return goes_on ? 0 : end - at;
}

}  // namespace

std::string capitalised(std::string_view text) {
    std::string result(text);
    if (!result.empty()) {
        result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
    }
    return result;
}

std::string shown_sentence(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = number_length(text, i);
        if (length == 0) {
            result += text[i++];
            continue;
        }
        result += '`';
        result += text[i] == '-' ? "−" + std::string(text.substr(i + 1, length - 1))
                                 : std::string(text.substr(i, length));
        i += length;
        if (text.substr(i).starts_with(" deg")) {
            result += "°";
            i += 4;
        } else if (text.substr(i).starts_with(" %")) {
            result += " %";
            i += 2;
        } else if (text.substr(i).starts_with(" mm") && !text.substr(i).starts_with(" mm²")) {
            result += " mm";
            i += 3;
        }
        result += '`';
    }
    if (!result.empty() && !result.ends_with('.') && !result.ends_with('?')) result += '.';
    return capitalised(result);
}

}  // namespace gripscan::ui
