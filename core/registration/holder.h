// What holds the part in a view: the gripper, measured in the same picture.
#pragma once

#include <string>

#include "core/geometry/pose.h"
#include "core/registration/surface.h"

namespace gripscan {

struct Holder {
    Surface surface;   ///< camera frame
    std::string flaw;  ///< why there is no surface; empty: there is one
    /// From its template's frame; found from its shape.
    Pose T_camera_holder = Pose::Identity();

    [[nodiscard]] bool usable() const { return flaw.empty(); }
};

/// A cloud that is too poor to register is no error but a flaw.
[[nodiscard]] Holder make_holder(const Cloud& cloud, const Pose& T_camera_holder);

}  // namespace gripscan
