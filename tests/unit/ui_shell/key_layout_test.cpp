// Which letter a key is, on keyboards of several countries.
#include "ui/shell/key_layout.h"

#include <gtest/gtest.h>

#include <map>

namespace gripscan::ui {
namespace {

/// The American keyboard, with other words on some keys.
LetterKeys keyboard(const std::map<char, std::string>& other) {
    return letter_keys([&](char place) {
        const auto found = other.find(place);
        return found != other.end() ? found->second : std::string(1, place);
    });
}

char letter_at(const LetterKeys& keys, char place) {
    return keys[static_cast<std::size_t>(place - 'A')];
}

TEST(KeyLayout, AmericanLettersAreWhereTheyAre) {
    const LetterKeys keys = keyboard({});
    for (char c = 'A'; c <= 'Z'; ++c) EXPECT_EQ(letter_at(keys, c), c);
}

TEST(KeyLayout, GermanYAndZChangePlaces) {
    const LetterKeys keys = keyboard({{'Y', "z"}, {'Z', "y"}});
    EXPECT_EQ(letter_at(keys, 'Y'), 'Z');
    EXPECT_EQ(letter_at(keys, 'Z'), 'Y');
    EXPECT_EQ(letter_at(keys, 'A'), 'A');
    std::array<bool, 512> down{};
    down['Y'] = true;  // the key on which a German reads Z
    put_letters_right(keys, down);
    EXPECT_TRUE(down['Z']);
    EXPECT_FALSE(down['Y']);
}

TEST(KeyLayout, OnAFrenchKeyboardAnOtherSignIsNoLetter) {
    // AZERTY: a and q, z and w change places; m stands beside l, and a comma at its place.
    const LetterKeys keys = keyboard({{'A', "q"}, {'Q', "a"}, {'W', "z"}, {'Z', "w"}, {'M', ","}});
    EXPECT_EQ(letter_at(keys, 'Q'), 'A');
    EXPECT_EQ(letter_at(keys, 'W'), 'Z');
    EXPECT_EQ(letter_at(keys, 'M'), 'M') << "no other of the 26 keys has an M";
}

TEST(KeyLayout, KeysWithoutLatinLettersKeepTheirPlace) {
    const LetterKeys keys = letter_keys([](char) { return std::string("\xD1\x84"); });
    for (char c = 'A'; c <= 'Z'; ++c) EXPECT_EQ(letter_at(keys, c), c);
}

TEST(KeyLayout, OtherKeysStayAsTheyAre) {
    const LetterKeys keys = keyboard({{'Y', "z"}, {'Z', "y"}});
    std::array<bool, 512> down{};
    down[32] = down[290] = true;
    put_letters_right(keys, down);
    EXPECT_TRUE(down[32]);
    EXPECT_TRUE(down[290]);
    EXPECT_EQ(std::count(down.begin(), down.end(), true), 2);
}

}  // namespace
}  // namespace gripscan::ui
