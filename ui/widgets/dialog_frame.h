// The frame of a dialog: a card with title, a body that scrolls where there is no room, and a row
// of buttons. A solid ring sets it off from what lies behind.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ui/widgets/button.h"
#include "ui/widgets/scroll_area.h"

namespace gripscan::ui {

struct DialogSpec {
    std::string_view id;  ///< "dialog.open"
    std::string_view title;
    float width_em = 34.0F;  ///< 476 px
    int body_height = 0;     ///< px that the body wants
    bool modal = true;       ///< nothing behind it takes the mouse
};

/// begin, draw the body in body(), then footer(), in which the buttons are drawn, then end.
class DialogFrame {
  public:
    /// `room`: what it may cover; it stands in the middle and never leaves it.
    DialogFrame(const Ui& ui, const Rect& room, const DialogSpec& spec);
    DialogFrame(const DialogFrame&) = delete;
    DialogFrame& operator=(const DialogFrame&) = delete;

    /// In its first frame: what the dialog starts from is set now.
    [[nodiscard]] bool appeared() const { return appeared_; }
    /// Where the body begins, scrolled.
    [[nodiscard]] const Rect& body() const { return body_; }
    void end_body(int content_end_y);
    [[nodiscard]] const Rect& footer() const { return footer_; }
    /// Escape, or the cross was clicked.
    [[nodiscard]] bool closed() const { return closed_; }
    /// Enter, while no field and no other button has the keyboard.
    [[nodiscard]] bool confirmed() const { return confirmed_; }
    void end();

  private:
    const Ui& ui_;
    Rect body_;
    Rect footer_;
    bool appeared_ = false;
    bool closed_ = false;
    bool confirmed_ = false;
    std::optional<ScrollArea> scroll_;
};

/// Buttons at the right of the footer, the last one is the confirming one; an empty label is none.
/// Returns the index of the one that was clicked, or of the last where Enter confirmed it.
[[nodiscard]] std::optional<std::size_t> dialog_buttons(const Ui& ui, const DialogFrame& frame,
                                                        std::span<const ButtonSpec> buttons);

}  // namespace gripscan::ui
