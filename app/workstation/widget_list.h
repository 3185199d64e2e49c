// Where the controls of the window are, as a file: for whoever drives the window from outside.
#pragma once

#include <filesystem>
#include <string>

#include "ui/widgets/widget_log.h"

namespace gripscan::app {

/// gripscan-widgets/1: {"format": …, "widgets": [{"id", "label", "rect": [x, y, w, h], "enabled",
/// "reason", "keyboard"}, …]}, px.
[[nodiscard]] std::string widget_list_json(const ui::WidgetLog& shown);

/// Writes it whenever it has changed. The file appears whole.
class WidgetList {
  public:
    explicit WidgetList(std::filesystem::path file) : file_(std::move(file)) {}
    void tell(const ui::WidgetLog& shown);

  private:
    std::filesystem::path file_;
    std::string last_;
};

}  // namespace gripscan::app
