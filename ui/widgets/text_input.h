// Typed words: one line, or a few.
#pragma once

#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct TextSpec {
    std::string_view id = {};
    std::string_view label = {};  ///< for the log
    std::string_view placeholder = {};
    Icon icon = Icon::kNone;     ///< at the left
    bool lines = false;          ///< fills its rectangle with several lines
    bool numbers = false;        ///< in the face of numbers: paths, keys
    bool wrong = false;          ///< what stands there cannot be taken
    bool take_keyboard = false;  ///< in this frame
    bool to_end = false;         ///< what stands there was set by the program: cursor to its end
    std::string_view why_disabled = {};
};

struct TextEvent {
    bool changed = false;  ///< in this frame
    bool entered = false;  ///< Enter, of one line
};

[[nodiscard]] TextEvent text_input(const Ui& ui, const Rect& rect, const TextSpec& spec,
                                   std::string& text);

}  // namespace gripscan::ui
