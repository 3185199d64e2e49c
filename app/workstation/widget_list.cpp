#include "app/workstation/widget_list.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace gripscan::app {

std::string widget_list_json(const ui::WidgetLog& shown) {
    using Json = nlohmann::ordered_json;
    Json widgets = Json::array();
    for (const ui::WidgetRecord& record : shown.records()) {
        const ui::Rect& r = record.rect;
        widgets.push_back({{"id", record.id},
                           {"label", record.label},
                           {"rect", {r.x, r.y, r.width, r.height}},
                           {"enabled", record.enabled},
                           {"reason", record.reason},
                           {"keyboard", record.has_keyboard}});
    }
    return Json{{"format", "gripscan-widgets/1"}, {"widgets", widgets}}.dump(1) + "\n";
}

void WidgetList::tell(const ui::WidgetLog& shown) {
    std::string text = widget_list_json(shown);
    if (text == last_) return;
    last_ = std::move(text);
    // Read by polling: renamed into place, but not synced, which would slow the frames down.
    const std::filesystem::path beside = file_.string() + ".part";
    std::ofstream(beside, std::ios::binary) << last_;
    std::error_code ignored;
    std::filesystem::rename(beside, file_, ignored);
}

}  // namespace gripscan::app
