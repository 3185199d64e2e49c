// A recorded turn as the pipeline takes it: what is known of each capture, and where its data come
// from. Loading is asked for capture by capture, so that a recording never lies in memory whole.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/camera/stereo_source.h"
#include "core/cloud/cloud.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/registration/verdict.h"

namespace gripscan {

/// One line of a recording. A used one has `load_images` or `load_cloud`; both may be called from
/// any thread.
struct RecordedCapture {
    int index = 0;
    bool used = true;
    int attempts = 1;
    std::optional<double> commanded_rad;     ///< turn since the first capture
    std::optional<double> joint6_rad;        ///< before the exposure
    std::optional<double> joint6_after_rad;  ///< after it
    std::optional<std::array<double, 5>> other_joints_rad;
    TurnMode mode = TurnMode::kFree;  ///< of the step that leads to this capture
    std::string note;                 ///< the operator overrules that step's verdict; empty: not
    std::function<Result<StereoFrame>()> load_images;
    std::function<Result<Cloud>()> load_cloud;
};

struct TurnRecording {
    std::optional<StereoRig> rig;  ///< needed where captures have images
    std::optional<Box> region;     ///< registration area, camera frame
    std::vector<RecordedCapture> captures;
};

}  // namespace gripscan
