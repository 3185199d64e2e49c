// The type of the window: Inter for words, JetBrains Mono for every number that can change, each
// baked at the size it is drawn at.
#pragma once

#include <imgui.h>

#include <array>

#include "core/base/result.h"
#include "ui/fonts/icon.h"
#include "ui/layout/scale.h"

namespace gripscan::ui {

enum class FontRole {
    kHeading,     ///< of the start page
    kTitle,       ///< step, session, view
    kTitleLight,  ///< "of 36"
    kVerdict,     ///< verdict word, dialog title
    kText,
    kTextStrong,
    kButton,
    kNextAction,
    kPanelTitle,  ///< and tabs
    kTable,       ///< and evidence, status bar
    kTableStrong,
    kSmall,    ///< log, second lines
    kCaption,  ///< column groups, legend ticks, units
    kNumber,   ///< in a sentence
    kNumberTable,
    kNumberSmall,
    kNumberCaption,
    kDial,
    kIcon,
    kIconSmall,
    kCount
};

class FontSet {
  public:
    /// Clears the atlas and bakes every role at that scale. The texture has to be made anew after
    /// it. Fails where a font file is missing.
    [[nodiscard]] static Result<FontSet> bake(ImFontAtlas& atlas, Scale scale);

    [[nodiscard]] ImFont* operator[](FontRole role) const {
        return fonts_[static_cast<std::size_t>(role)];
    }
    /// Text size in px, as designers count it (em), of a role.
    [[nodiscard]] float em_px(FontRole role) const {
        return em_px_[static_cast<std::size_t>(role)];
    }

  private:
    static constexpr auto kRoles = static_cast<std::size_t>(FontRole::kCount);
    std::array<ImFont*, kRoles> fonts_{};
    std::array<float, kRoles> em_px_{};
};

}  // namespace gripscan::ui
