// `recognise --json`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/recognition/grasp.h"
#include "core/recognition/recognise.h"

namespace gripscan {

/// A detection with what is known of the cell around it.
struct PlacedDetection {
    int capture = 0;
    Detection detection;
    std::optional<Pose> T_robot_template;
    std::optional<Pose> T_gripper_template;  ///< where a gripper was found in the same view
    std::optional<GraspPose> grasp;          ///< where all that it takes is known
};

[[nodiscard]] std::string recognition_json(const std::vector<PlacedDetection>& detections);

}  // namespace gripscan
