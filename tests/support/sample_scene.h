// A turn of the synthetic part as the window would show it: what the 3D view and the stereo panel
// are tested with.
#pragma once

#include <memory>

#include "ui/views/snapshot.h"

namespace gripscan::test {

/// A snapshot and the state it points at.
struct SampleScene {
    std::shared_ptr<ProcedureState> state = std::make_shared<ProcedureState>();
    ui::Snapshot snapshot;
};

inline constexpr int kSceneViews = 36;  ///< of the whole turn

/// The axis that the part is turned about, in the camera frame.
[[nodiscard]] Axis scene_axis();

/// A session that is not connected: no cloud.
[[nodiscard]] SampleScene empty_scene();
/// Captures 0 … steps, all steps accepted. `points`: of the whole part.
[[nodiscard]] SampleScene growing_scene(int steps, std::size_t points = 60000);
/// The same with a last step that the registration turned by so much too far: rejected.
[[nodiscard]] SampleScene rejected_scene(int steps, double error_rad, std::size_t points = 60000);
/// The whole turn, solved and merged, on the Template page.
[[nodiscard]] SampleScene template_scene(std::size_t points = 60000);

/// Images of a made-up exposure: 320 × 240, a disparity, health.
[[nodiscard]] std::shared_ptr<const ui::StereoPicture> sample_picture();

}  // namespace gripscan::test
