#include "core/procedure/cell_report.h"

#include <array>

namespace gripscan {

std::string_view word(CheckOutcome outcome) {
    constexpr std::array<std::string_view, 4> kWords{"passed", "warned", "failed", "skipped"};
    return kWords[static_cast<std::size_t>(outcome)];
}

}  // namespace gripscan
