// What a camera could see of a template: the points that face it and have nothing of the template
// before them.
#pragma once

#include "core/cloud/cloud.h"

namespace gripscan {

/// Of a thin template (one point every millimetre or so, with normals) at T, in the camera's frame.
/// The result has no viewpoint: its points come from many views.
[[nodiscard]] Cloud template_front(const Cloud& thin, const Pose& T_camera_template,
                                   const Eigen::Vector3f& viewpoint);

}  // namespace gripscan
