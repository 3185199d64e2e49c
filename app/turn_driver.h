// A turn without a window: gives the engine the commands an operator would, and waits.
#pragma once

#include "app/context.h"
#include "core/procedure/engine.h"

namespace gripscan::app {

struct DriverOptions {
    bool resumed = false;  ///< the state comes from a journal
};

/// How the drive ended. An error is one of device, disk or cancelled.
enum class TurnEnd {
    kFinished,     ///< the turn is complete and solved
    kStopped,      ///< the advisor asks for the operator; what there is has been solved
    kNothing,      ///< the same, with too few views to solve anything
    kRehearsed,    ///< DRY: every motion was written down
    kCellRefused,  ///< the cell check has failed
};

struct DrivenTurn {
    TurnEnd end = TurnEnd::kNothing;
    ProcedureState state;
};

[[nodiscard]] Result<DrivenTurn> drive_turn(Engine& engine, const DriverOptions& options,
                                            const Context& context);

}  // namespace gripscan::app
