// Check sums against accidental damage (not against forgery).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gripscan {

/// FNV-1a with 64 bits (Fowler, Noll, Vo).
[[nodiscard]] constexpr std::uint64_t fnv1a64(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3ULL;
    }
    return hash;
}

/// "fnv1a64:" and 16 hexadecimal digits.
[[nodiscard]] std::string checksum_text(std::string_view bytes);

}  // namespace gripscan
