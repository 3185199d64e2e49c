#include "core/procedure/advice.h"

#include <array>

namespace gripscan {

std::string_view word(AdvisedAction action) {
    constexpr std::array<std::string_view, 5> kWords{"retake", "halve", "lock the axis", "go on",
                                                     "stop and ask"};
    return kWords[static_cast<std::size_t>(action)];
}

}  // namespace gripscan
