#include "app/session_settings.h"

#include "core/report/gripper_template_file.h"
#include "core/scene/environment_file.h"

namespace gripscan::app {
namespace {

constexpr std::string_view kEnvironmentFile = "environment.bin";

Result<std::shared_ptr<const EnvironmentModel>> kept_environment(const Session& session) {
    const auto path = session.folder / kEnvironmentFile;
    std::error_code code;
    if (!std::filesystem::exists(path, code)) return nullptr;
    auto model = load_environment(path);
    if (!model) return forward_error(model.error());
    return std::make_shared<const EnvironmentModel>(std::move(*model));
}

}  // namespace

Status keep_environment(const std::filesystem::path& folder, const EnvironmentModel& model) {
    return save_environment(folder / kEnvironmentFile, model);
}

Result<ComputeTurnSettings> session_settings(const Session& session, const TurnOptions& options) {
    ComputeTurnSettings settings = compute_settings_of(session);
    options.apply_to(settings);
    auto environment = kept_environment(session);
    if (!environment) return forward_error(environment.error());
    settings.environment = std::move(*environment);
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
