// template.json: where a template comes from, so that whoever loads it can tell whether it is still
// what the recording says.
#pragma once

#include <string>

#include "core/procedure/compute_turn.h"
#include "core/session/session.h"

namespace gripscan {

struct Provenance {
    const Session& session;
    const ComputeTurnSettings& settings;
    std::string version;                          ///< of the software
    std::optional<HeldPose> held = std::nullopt;  ///< of an object: how the gripper holds it
};

/// Unit, frame with axis and joint 6, points, check sums of every source file, settings, closure,
/// summary of Table 1; of an object the gripper that held it, with T_gripper_object: from the
/// object template's frame into the gripper template's, as it was held. Each frame is the camera's
/// with the part as in the first used capture of its own session.
[[nodiscard]] Result<std::string> template_json(const TurnReport& report, const Provenance& from);

}  // namespace gripscan
