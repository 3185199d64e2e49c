// The result of one alignment as JSON, as `align --json` prints it.
#pragma once

#include <optional>
#include <string>

#include "core/registration/align.h"

namespace gripscan {

/// T maps SOURCE onto TARGET; null where none was found. `rotation_rad`: what the turn should have
/// been, where that is known.
[[nodiscard]] std::string alignment_json(const Alignment& alignment,
                                         const std::optional<double>& rotation_rad);

}  // namespace gripscan
