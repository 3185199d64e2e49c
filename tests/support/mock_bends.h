// What broken servers make of what they hear and say.
#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/mock_client.h"
#include "tests/support/replaced.h"

namespace gripscan::test {

/// One text instead of another, wherever it stands.
inline Bend with(std::string what, std::string by) {
    return [what = std::move(what), by = std::move(by)](std::string text) {
        return replaced(std::move(text), what, by);
    };
}

/// For lines that begin so, another line.
inline Bend instead_of(std::string beginning, std::string line) {
    return [beginning = std::move(beginning), line = std::move(line)](std::string text) {
        return text.starts_with(beginning) ? line : text;
    };
}

/// Positions with another word: 0 is the time, 1 … 6 the joints, 7 … 12 the pose, then the frames.
inline Bend with_position_word(std::size_t index, std::string word) {
    return [index, word = std::move(word)](std::string line) {
        const auto at = line.find("POS ");
        if (at == std::string::npos) return line;
        std::istringstream words(line.substr(at + 4));
        std::string result = line.substr(0, at) + "POS";
        std::string one;
        for (std::size_t i = 0; words >> one; ++i) result += " " + (i == index ? word : one);
        return result;
    };
}

/// Each line is cut after so many words.
inline Bend without_words_beyond(std::size_t count) {
    return [count](std::string bytes) {
        std::string result;
        std::size_t blanks = 0;
        for (const char c : bytes) {
            if (c == ' ') ++blanks;
            if (c == '\r' || c == '\n') blanks = 0;
            if (blanks < count) result += c;
        }
        return result;
    };
}

/// Longer lines are taken for lines of that length.
inline Bend without_characters_beyond(std::size_t length) {
    return [length](std::string bytes) {
        return bytes.size() > length ? bytes.substr(0, length) + "\r\n" : bytes;
    };
}

/// Every segment is taken for a line.
inline Bend with_a_line_a_segment() {
    return [](std::string bytes) { return bytes + "\r\n"; };
}

/// What follows the first line of a segment gets lost.
inline Bend without_a_second_line() {
    return [](std::string bytes) {
        const auto begin = bytes.find_first_not_of("\r\n");
        const auto end = begin == std::string::npos ? begin : bytes.find_first_of("\r\n", begin);
        return end == std::string::npos ? bytes : bytes.substr(0, end) + "\r\n";
    };
}

/// Only the lower seven bits of each byte are heard.
inline Bend without_eighth_bit() {
    return [](std::string bytes) {
        for (char& byte : bytes) byte = static_cast<char>(byte & 0x7F);
        return bytes;
    };
}

}  // namespace gripscan::test
