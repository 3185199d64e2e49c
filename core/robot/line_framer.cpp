#include "core/robot/line_framer.h"

#include <fmt/format.h>

#include <utility>

namespace gripscan {

void LineFramer::feed(std::string_view bytes) {
    for (const char byte : bytes) {
        if (broken_) return;
        if (byte == '\r' || byte == '\n') {
            end_line();
        } else if (static_cast<unsigned char>(byte) > 0x7F) {
            break_off(fmt::format("byte 0x{:02X} is not ASCII", static_cast<unsigned char>(byte)));
        } else if (line_.size() == kLongestBearable) {
            break_off(fmt::format("a line of more than {} characters", kLongestBearable));
        } else {
            line_ += byte;
        }
    }
}

std::optional<FramedItem> LineFramer::next() {
    if (items_.empty()) return std::nullopt;
    FramedItem item = std::move(items_.front());
    items_.pop_front();
    return item;
}

void LineFramer::end_line() {
    if (line_.empty()) return;
    if (line_.size() > kLongestLine) {
        items_.emplace_back(OverlongLine{line_.size()});
    } else {
        items_.emplace_back(Line{line_});
    }
    line_.clear();
}

void LineFramer::break_off(std::string why) {
    broken_ = true;
    line_.clear();
    items_.emplace_back(BrokenStream{std::move(why)});
}

}  // namespace gripscan
