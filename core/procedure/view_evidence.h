// What stereo knows of a capture, in the words of the registration.
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/registration/image_health.h"
#include "core/registration/step_evidence.h"
#include "core/registration/view_field.h"
#include "core/stereo/background_shift.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan {

[[nodiscard]] ImageHealth image_health_of(const StereoHealth& health);
[[nodiscard]] ViewField field_of(const RectifiedRig& rig);

/// The background beside the registration area; nothing without a region.
[[nodiscard]] std::optional<Background> background_beside(const StereoFrame& rectified,
                                                          const RectifiedRig& rig,
                                                          const std::optional<Box>& region);
[[nodiscard]] std::optional<CameraShift> camera_shift_of(const Background& before,
                                                         const Background& now);

}  // namespace gripscan
