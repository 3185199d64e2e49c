// What a panel asks for, in words: for tests that compare it with an approved text.
#pragma once

#include <string>

#include "ui/views/request.h"

namespace gripscan::test {

/// "Give step", "Show kExport": the kind, and what tells two of a kind apart.
[[nodiscard]] std::string request_text(const ui::Request& request);

}  // namespace gripscan::test
