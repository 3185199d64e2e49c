#include "core/session/capture_joints.h"

#include "core/base/units.h"

namespace gripscan {

std::optional<JointAngles> joints_rad(const CaptureRow& row) {
    JointAngles joints{};
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!row.joints_deg[i]) return std::nullopt;
        joints[i] = rad_from_deg(*row.joints_deg[i]);
    }
    return joints;
}

}  // namespace gripscan
