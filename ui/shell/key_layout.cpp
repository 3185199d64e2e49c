#include "ui/shell/key_layout.h"

#include <algorithm>
#include <cctype>

namespace gripscan::ui {
namespace {

constexpr char kNone = '\0';

char latin_letter(const std::string& name) {
    if (name.size() != 1) return kNone;
    const auto c = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return c >= 'A' && c <= 'Z' ? c : kNone;
}

}  // namespace

LetterKeys letter_keys(const std::function<std::string(char place)>& name_of) {
    LetterKeys letters{};
    for (std::size_t i = 0; i < letters.size(); ++i) {
        letters[i] = latin_letter(name_of(static_cast<char>('A' + i)));
    }
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const auto place = static_cast<char>('A' + i);
        if (letters[i] != kNone || std::ranges::find(letters, place) != letters.end()) continue;
        letters[i] = place;
    }
    return letters;
}

void put_letters_right(const LetterKeys& letters, std::span<bool> down) {
    std::array<bool, 26> by_letter{};
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (letters[i] == kNone || !down['A' + i]) continue;
        by_letter[static_cast<std::size_t>(letters[i] - 'A')] = true;
    }
    std::ranges::copy(by_letter, down.begin() + 'A');
}

}  // namespace gripscan::ui
