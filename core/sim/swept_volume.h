// The room that the turning parts take up over a whole turn of joint 6, as a solid of revolution.
// What a ray sees outside it does not depend on joint 6.
#pragma once

#include "core/sim/scene_model.h"

namespace gripscan::sim {

/// A scene with that one solid, mounted on tool0; it encloses the turning parts by at least 0.2 mm
/// and by `slack_m` more, for parts that may be moved on the flange by up to that.
/// Without turning parts there is nothing in it.
[[nodiscard]] SceneModel swept_scene(const SceneModel& model, double slack_m = 0.0);

}  // namespace gripscan::sim
