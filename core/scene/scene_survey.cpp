#include "core/scene/scene_survey.h"

#include <fmt/format.h>

#include "core/base/units.h"

namespace gripscan {

Result<SceneSurvey> survey_scene(const EnvironmentModel& model, const Cloud& scene,
                                 const SceneKnowledge& knowledge, const SurveySettings& settings,
                                 const Progress& progress, const ForEach& for_each) {
    SceneSurvey survey;
    auto shift = environment_shift(model, scene, settings.shift, progress, for_each);
    if (!shift) return forward_error(shift.error());
    survey.shift = *shift;
    const Pose T_model_scene = shift->moved ? shift->T_model_scene : Pose::Identity();
    const auto kinds = model.classify(scene, settings.subtract, for_each, T_model_scene);
    std::vector<std::size_t> other;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const Eigen::Vector3d p = scene.points[i].cast<double>();
        if (knowledge.region && !knowledge.region->contains(p)) continue;
        ++survey.points;
        if (kinds[i] == ScenePoint::kEnvironment || kinds[i] == ScenePoint::kBehind) {
            ++survey.environment;
        } else {
            other.push_back(i);
        }
    }
    std::vector<std::size_t> not_arm = knowledge.arm ? knowledge.arm->outside(scene, other) : other;
    // Where the arm was seen to come; never inside the region, so that nothing there is overlooked.
    std::erase_if(not_arm, [&](std::size_t i) {
        return model.arm.near(scene.points[i].cast<double>()) && !knowledge.region;
    });
    survey.arm = other.size() - not_arm.size();
    const auto unknown = without_known(scene, not_arm, knowledge.things);
    survey.known = not_arm.size() - unknown.size();
    if (progress.cancelled()) return cancelled_error();
    survey.left_overs = find_left_overs(scene, unknown, settings.left_over);
    return survey;
}

std::string sentence(const EnvironmentShift& shift) {
    if (!shift.known)
        return "whether the environment has moved cannot be told: too little of it is seen";
    const Eigen::Vector3d mm = kMmPerM * shift.shift_m;
    return fmt::format(
        "the environment stands {:.2f} +- {:.2f} mm (x {:+.2f}, y {:+.2f}, z {:+.2f}) and {:.3f} "
        "deg from where it was learned{}",
        mm.norm(), kMmPerM * shift.sd_m, mm.x(), mm.y(), mm.z(), deg_from_rad(shift.turn_rad),
        shift.moved ? ": it or the camera was moved; put it back or learn it again" : "");
}

}  // namespace gripscan
