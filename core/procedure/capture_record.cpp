#include "core/procedure/capture_record.h"

#include <array>

namespace gripscan {

std::string_view word(CaptureStatus status) {
    constexpr std::array<std::string_view, 3> kWords{"used", "superseded", "excluded"};
    return kWords[static_cast<std::size_t>(status)];
}

}  // namespace gripscan
