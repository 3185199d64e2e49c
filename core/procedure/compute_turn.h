// The one pipeline from a recording to Table 1 and the template: stereo, crop, registration.
// Replay, the automatic run and the window all call this.
#pragma once

#include <memory>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/procedure/turn_recording.h"
#include "core/registration/solve_turn.h"
#include "core/scene/environment_model.h"
#include "core/scene/held_pose.h"
#include "core/scene/object_split.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan {

struct ComputeTurnSettings {
    StereoSettings stereo;
    TurnSettings turn;
    /// Clouds are cut to the region. Off: only matching is limited by it.
    bool crop = true;
    /// What stands still where the camera looks, to be taken away from every capture; null: nothing
    /// was learned.
    std::shared_ptr<const EnvironmentModel> environment;
    /// Of an object's turn: the gripper that holds it, to be taken away from every capture.
    std::shared_ptr<const GripperTemplate> gripper;
    ObjectSplitSettings split;
};

struct ComputedTurn {
    TurnReport report;  ///< `poses` has one entry per capture of the recording, in order
    /// Per capture; nothing where it was not used or came as a cloud.
    std::vector<std::optional<StereoHealth>> health;
    std::optional<HeldPose> held;  ///< of an object's turn: how the gripper holds it
};

/// The result does not depend on the number of threads. Errors: captures that cannot be loaded or
/// hold no points (named by their index), fewer than two used ones, cancelled. Steps that do not
/// agree with the robot are rows of the report.
[[nodiscard]] Result<ComputedTurn> compute_turn(const TurnRecording& recording,
                                                const ComputeTurnSettings& settings,
                                                const Progress& progress, const ForEach& for_each);

}  // namespace gripscan
