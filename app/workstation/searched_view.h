// A view for recognition: all that the camera sees, as a cloud and as images.
#pragma once

#include "app/workstation/recognition_desk.h"
#include "core/camera/stereo_source.h"

namespace gripscan::app {

/// Rectifies, matches the whole image. Errors: a rig that makes no sense, images that do not fit
/// it, cancelled.
[[nodiscard]] Result<SearchedView> searched_view(const StereoRig& rig, const StereoFrame& frame,
                                                 const Progress& progress, const ForEach& for_each);

}  // namespace gripscan::app
