// Letter keys by what stands on them. GLFW numbers them by their place on an American keyboard, so
// that Ctrl+Z would lie on the key Y of a German one.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>

namespace gripscan::ui {

/// For each key from A to Z, as GLFW numbers them by place: the letter whose key it is.
using LetterKeys = std::array<char, 26>;

/// `name_of` tells what is printed on the key at a letter's American place, as GLFW does. A key
/// with no Latin letter on it (Cyrillic, Greek) keeps the letter of its place, if no other key has
/// that.
[[nodiscard]] LetterKeys letter_keys(const std::function<std::string(char place)>& name_of);

/// The keys that are down, with the letters where they belong. `down` is by GLFW's numbers, and
/// longer than 'Z'.
void put_letters_right(const LetterKeys& letters, std::span<bool> down);

}  // namespace gripscan::ui
