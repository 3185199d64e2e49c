// What the window shows in this frame: every control with its place, so that a test or a scripted
// tour can press it by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/layout/rect.h"

namespace gripscan::ui {

struct WidgetRecord {
    std::string id;     ///< stable, not translated: "step.capture"
    std::string label;  ///< as it is shown
    Rect rect;
    bool enabled = true;
    std::string reason;         ///< why it is disabled
    bool has_keyboard = false;  ///< what is typed goes there
};

class WidgetLog {
  public:
    void begin_frame() { records_.clear(); }
    void record(WidgetRecord record) { records_.push_back(std::move(record)); }

    [[nodiscard]] const std::vector<WidgetRecord>& records() const { return records_; }
    /// Nothing if it is not shown in this frame.
    [[nodiscard]] std::optional<WidgetRecord> find(std::string_view id) const {
        for (const WidgetRecord& record : records_) {
            if (record.id == id) return record;
        }
        return std::nullopt;
    }

  private:
    std::vector<WidgetRecord> records_;
};

}  // namespace gripscan::ui
