// The words of the 3D view: what stands there while it is empty, and below a picture of it. Pure.
#pragma once

#include <string>

#include "ui/views/scene_parts.h"

namespace gripscan::ui {

/// What stands in the view while there is no cloud.
struct EmptyText {
    std::string title;
    std::string what_to_do;
};
[[nodiscard]] EmptyText empty_scene_text(const Snapshot& snapshot);

/// Below a picture of the view: "valve-T20, step 14 of 36, 140.0°, 412 870 points".
[[nodiscard]] std::string scene_caption(const Snapshot& snapshot, const SceneParts& parts);

}  // namespace gripscan::ui
