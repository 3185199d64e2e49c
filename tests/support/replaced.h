// One text instead of another, wherever it stands.
#pragma once

#include <string>
#include <string_view>

namespace gripscan::test {

inline std::string replaced(std::string text, std::string_view what, std::string_view by) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
    return text;
}

}  // namespace gripscan::test
