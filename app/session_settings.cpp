#include "app/session_settings.h"

#include "core/report/gripper_template_file.h"

namespace gripscan::app {

Result<ComputeTurnSettings> session_settings(const Session& session, const TurnOptions& options) {
    ComputeTurnSettings settings = compute_settings_of(session);
    options.apply_to(settings);
    if (session.spec.kind != SessionKind::kObject) return settings;
    if (!session.spec.gripper_template) {
        return input_error(
            "{}: a session of kind object names no gripper_template; without it the gripper cannot "
            "be told from the object",
            (session.folder / "session.yaml").string());
    }
    auto gripper = load_gripper_template(session.folder, *session.spec.gripper_template);
    if (!gripper) return forward_error(gripper.error());
    settings.gripper = std::move(*gripper);
    return settings;
}

}  // namespace gripscan::app
