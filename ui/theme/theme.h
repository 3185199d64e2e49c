// The colours of the window by what they mean. Blue means "do this next" or "selected"; green,
// amber and red are verdicts and limits, always with their word or shape.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "ui/theme/colour.h"

namespace gripscan::ui {

struct Theme {
    std::string name;  ///< as the settings show it
    bool dark = true;

    // Words and numbers.
    Colour text;
    Colour text_second;  ///< labels, secondary columns
    Colour text_third;   ///< captions, limits, units, what is disabled

    // The next action and the selection.
    Colour accent;
    Colour accent_on;    ///< text on the accent
    Colour accent_text;  ///< links, measured points, the ghost
    Colour accent_bg;

    // Verdicts.
    Colour ok;
    Colour ok_bg;
    Colour check;
    Colour check_bg;
    Colour reject;
    Colour reject_bg;

    // The robot's mode.
    Colour live;
    Colour live_on;  ///< text on it
    Colour sim;
    Colour sim_bg;

    // Things in the cell.
    Colour axis;  ///< the joint axis, the turn so far, the row ruler
    Colour gripper;
    Colour object;
    Colour axis_x;
    Colour axis_y;
    Colour axis_z;

    // The two clouds of a step.
    Colour target;
    Colour source;
    Colour target_safe;  ///< the pair for colour-blind users
    Colour source_safe;

    // Surfaces.
    Colour bg0;  ///< gaps, start page
    Colour input;
    Colour panel;
    Colour raised;
    Colour hover;
    Colour select;
    Colour line;   ///< separators
    Colour line2;  ///< borders of buttons, cards, dialogs
    Colour edge;   ///< borders of inputs, check boxes
    Colour view_top;
    Colour view_bottom;
    Colour plate;  ///< behind labels on camera images
    Colour plate_text;
    Colour too_few;  ///< points below the range of a legend
};

/// One colour of the theme and its name in the file.
struct ThemeToken {
    std::string_view name;
    Colour Theme::*colour;
};
[[nodiscard]] std::span<const ThemeToken> theme_tokens();

/// From the text of a theme file (gripscan-theme/1). Every token must be there and no other; the
/// error names the token. `file` is only for the message.
[[nodiscard]] Result<Theme> theme_from_json(std::string_view text, std::string_view file);

enum class ThemeChoice { kDark, kLight };
/// assets/themes/dark.json or light.json.
[[nodiscard]] Result<Theme> load_theme(ThemeChoice choice);

}  // namespace gripscan::ui
