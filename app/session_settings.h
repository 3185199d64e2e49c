// How the turn of a session is computed: its own limits, the options, and for an object's turn the
// template of the gripper that holds it.
#pragma once

#include "app/turn_options.h"
#include "core/session/session.h"

namespace gripscan::app {

/// Errors: the gripper's template of an object's session is not named or cannot be used.
[[nodiscard]] Result<ComputeTurnSettings> session_settings(const Session& session,
                                                           const TurnOptions& options);

}  // namespace gripscan::app
