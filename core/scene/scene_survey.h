// A look at the cell against all that is known of it: has the environment moved, and is anything in
// the registration area that does not belong there?
#pragma once

#include <optional>
#include <span>

#include "core/geometry/box.h"
#include "core/scene/arm_zone.h"
#include "core/scene/environment_shift.h"
#include "core/scene/left_over.h"

namespace gripscan {

/// What is known besides the environment.
struct SceneKnowledge {
    std::optional<Box> region;   ///< registration area, camera frame; none: everywhere
    std::optional<ArmZone> arm;  ///< none: not aligned, or out of the picture
    std::span<const KnownThing> things;
};

struct SurveySettings {
    SubtractSettings subtract;
    ShiftSettings shift;
    LeftOverSettings left_over;
};

struct SceneSurvey {
    EnvironmentShift shift;
    std::vector<LeftOver> left_overs;
    std::size_t points = 0;       ///< of the scene, in the region
    std::size_t environment = 0;  ///< of these, the environment's
    std::size_t arm = 0;          ///< the arm's
    std::size_t known = 0;        ///< the known things'

    [[nodiscard]] bool clear() const { return left_overs.empty() && !shift.moved; }
};

/// `scene` is the organised cloud of the whole image, so that the environment around the region
/// tells whether it has moved; a shift that was found is taken into account before subtracting.
/// Errors: as EnvironmentModel::fits(), cancelled.
[[nodiscard]] Result<SceneSurvey> survey_scene(const EnvironmentModel& model, const Cloud& scene,
                                               const SceneKnowledge& knowledge,
                                               const SurveySettings& settings,
                                               const Progress& progress, const ForEach& for_each);

/// "the environment stands 2.03 mm (x +1.2, y -0.4, z +1.6) from where it was learned …".
[[nodiscard]] std::string sentence(const EnvironmentShift& shift);

}  // namespace gripscan
