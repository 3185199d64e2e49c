// Bytes to lines, wherever the segments of TCP begin and end. A line ends with CR, LF or both;
// empty lines are skipped.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace gripscan {

inline constexpr std::size_t kLongestLine = 200;      ///< characters, without its end
inline constexpr std::size_t kLongestBearable = 254;  ///< what the controller's strings can hold
inline constexpr std::string_view kLineEnd = "\r\n";

struct Line {
    std::string text;  ///< ASCII, without its end
};
/// A line that is too long, but was taken in: the link may stay.
struct OverlongLine {
    std::size_t length = 0;
};
/// Too long for the controller, or not ASCII: the link has to be closed.
struct BrokenStream {
    std::string why;
};
using FramedItem = std::variant<Line, OverlongLine, BrokenStream>;

class LineFramer {
  public:
    void feed(std::string_view bytes);
    /// The next item, if a whole one is there. Nothing comes after a BrokenStream.
    std::optional<FramedItem> next();
    /// No whole item is there.
    [[nodiscard]] bool empty() const { return items_.empty(); }
    /// Of a line whose end has not come.
    [[nodiscard]] const std::string& pending() const { return line_; }

  private:
    void end_line();
    void break_off(std::string why);

    std::string line_;
    std::deque<FramedItem> items_;
    bool broken_ = false;
};

}  // namespace gripscan
