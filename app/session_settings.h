// How the turn of a session is computed: its own limits, the options, the environment that it
// keeps, and for an object's turn the template of the gripper that holds it.
#pragma once

#include "app/turn_options.h"
#include "core/scene/environment_model.h"
#include "core/session/session.h"

namespace gripscan::app {

/// Copies a learned environment into a session, as environment.bin: from here on it is taken away
/// from every capture.
[[nodiscard]] Status keep_environment(const std::filesystem::path& folder,
                                      const EnvironmentModel& model);

/// Errors: the gripper's template of an object's session is not named or cannot be used; the
/// session's environment is damaged.
[[nodiscard]] Result<ComputeTurnSettings> session_settings(const Session& session,
                                                           const TurnOptions& options);

}  // namespace gripscan::app
