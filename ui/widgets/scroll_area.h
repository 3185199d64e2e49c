// A region whose content may be higher than it is: then it scrolls.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// Draw inside from `rect`.y on, `rect`.width wide; end() takes the y where the content ends.
class ScrollArea {
  public:
    ScrollArea(const Ui& ui, const Rect& region, std::string_view id);
    ScrollArea(const ScrollArea&) = delete;
    ScrollArea& operator=(const ScrollArea&) = delete;

    /// Where the content begins; its height is that of the region.
    [[nodiscard]] const Rect& rect() const { return rect_; }
    void end(int content_end_y);

  private:
    Rect rect_;
};

}  // namespace gripscan::ui
