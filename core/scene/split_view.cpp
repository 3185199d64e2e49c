#include "core/scene/split_view.h"

#include "core/registration/turn_rows.h"

namespace gripscan {

SplitView prepare_split_view(const GripperTemplate& gripper, const ObjectSplitSettings& settings,
                             const CaptureFacts& facts, Cloud scene) {
    SplitView made;
    const auto T_start = expected_pose(gripper, joint6_rad(facts));
    auto split = split_object(gripper, scene, T_start, settings);
    if (!split) {
        made.view = prepare_view(std::move(scene));
        made.view.flaw = std::move(split.error().message);
        return made;
    }
    made.view = prepare_view(split->object);
    if (!split->gripper.usable()) {
        made.view.flaw = split->sentence;
        made.view.flaw_cause = Cause::kNotConverged;
    } else {
        Holder holder = make_holder(split->gripper_part, split->gripper.T_camera_gripper);
        // What is only the robot's word is no witness of how the gripper moved.
        if (!split->gripper.trusted) holder.flaw = split->gripper.sentence;
        made.view.holder = std::make_shared<const Holder>(std::move(holder));
    }
    made.split = std::make_shared<const ObjectSplit>(std::move(*split));
    return made;
}

}  // namespace gripscan
