// The cell around the clouds as lines, and the words that stand at them.
#pragma once

#include <string>
#include <vector>

#include "ui/render/line_batch.h"
#include "ui/theme/theme.h"
#include "ui/views/scene_parts.h"

namespace gripscan::ui {

/// Words at a place in the scene.
struct SceneLabel {
    Eigen::Vector3d at_m = Eigen::Vector3d::Zero();
    std::string text;
    std::string second;  ///< below it, weaker
    Colour colour{};
    double dx_px = 0.0;  ///< at 100 %; the words end left of the place where it is negative
    double dy_px = 0.0;
};

struct SceneLines {
    LineBatch lines;
    std::vector<SceneLabel> labels;
};

/// What the lines depend on.
struct LineInput {
    const Snapshot& snapshot;
    const SceneParts& parts;
    const Theme& theme;
    const OrbitCamera& camera;
    Viewport viewport;
    Box around;                              ///< the visible clouds; not valid where there are none
    double px = 1.0;                         ///< of one px at 100 %
    bool show_cell = true;                   ///< else only what is worked with: the cuboid
    bool edits_region = false;               ///< the registration area is the cuboid
    std::optional<Eigen::Vector3d> pivot_m;  ///< shown as a cross
};
[[nodiscard]] SceneLines scene_lines(const LineInput& input);

/// Why the registration area is not the cuboid that can be dragged; empty: it is.
[[nodiscard]] std::string why_no_region_box(const Snapshot& snapshot, const SceneParts& parts);

/// The cuboid that can be dragged: of a template its crop, all of it where none is set; before a
/// turn the registration area of the next session; else nothing.
[[nodiscard]] std::optional<Box> editable_box(const Snapshot& snapshot, const SceneParts& parts,
                                              const Box& around);

}  // namespace gripscan::ui
