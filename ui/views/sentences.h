// Sentences of the core as the window shows them. Pure.
#pragma once

#include <string>
#include <string_view>

namespace gripscan::ui {

/// A sentence begins with a capital and ends with a full stop; numbers stand in back quotes, with
/// the signs and units of the screen: "error -0.021 deg" → "Error `−0.021°`."
[[nodiscard]] std::string shown_sentence(std::string_view text);
/// The first letter as a capital.
[[nodiscard]] std::string capitalised(std::string_view text);

}  // namespace gripscan::ui
