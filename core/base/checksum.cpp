#include "core/base/checksum.h"

#include <fmt/format.h>

namespace gripscan {

std::string checksum_text(std::string_view bytes) {
    return fmt::format("fnv1a64:{:016x}", fnv1a64(bytes));
}

}  // namespace gripscan
