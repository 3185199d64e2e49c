#include "app/tool_frame.h"

#include <algorithm>

#include "core/base/units.h"
#include "core/recognition/grasp.h"
#include "core/session/alignment_file.h"
#include "core/session/session.h"

namespace gripscan::app {

Result<Pose> tool_frame(const std::filesystem::path& folder,
                        const std::filesystem::path& alignment) {
    const auto T_robot_camera = load_robot_camera(alignment);
    if (!T_robot_camera) return forward_error(T_robot_camera.error());
    const auto session = open_session(folder);
    if (!session) return forward_error(session.error());
    const auto& rows = session->table.rows;
    const auto first = std::find_if(rows.begin(), rows.end(), [](const CaptureRow& row) {
        return row.status == CaptureStatus::kUsed;
    });
    if (first == rows.end()) return input_error("{} has no capture in use", folder.string());
    JointAngles joints_rad{};
    for (std::size_t i = 0; i < joints_rad.size(); ++i) {
        if (!first->joints_deg[i]) {
            return input_error(
                "{}: capture {} has no joint {}; without all six it is not known how the template "
                "sits on the flange",
                (folder / "captures.csv").string(), first->index, i + 1);
        }
        joints_rad[i] = rad_from_deg(*first->joints_deg[i]);
    }
    return T_tool_template(*T_robot_camera, joints_rad);
}

}  // namespace gripscan::app
