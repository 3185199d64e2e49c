// The words of commands and events, in the order of their variants: one each, never changed, as
// journals are read by them.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "core/procedure/input.h"

namespace gripscan {

template <typename Variant>
using WordsOf = std::array<std::string_view, std::variant_size_v<Variant>>;

/// Of Command or Event.
template <typename Variant>
[[nodiscard]] const WordsOf<Variant>& input_words();

template <>
[[nodiscard]] const WordsOf<Command>& input_words<Command>();
template <>
[[nodiscard]] const WordsOf<Event>& input_words<Event>();

}  // namespace gripscan
