// The stages of the procedure with their state and their exit criterion as a number. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/theme/state.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

struct StageText {
    std::string_view id;    ///< "stage.warm_up"
    std::string_view name;  ///< "Axis warm-up"
    State state = State::kWaiting;
    std::string criterion = {};    ///< "axis sd 0.04° ≤ 0.10°", "needs a cell check"
    std::string why = {};          ///< tooltip: the whole sentence; may be empty
    bool current = false;          ///< exactly one is
    Page page = Page::kProcedure;  ///< where its details are
};

/// Connect, cell check, environment, axis warm-up, gripper or object, recognise, export. The axis
/// warm-up is left out where the robot
/// may not be moved.
[[nodiscard]] std::vector<StageText> stages_of(const Snapshot& snapshot);

}  // namespace gripscan::ui
