// Which cell a resumed session goes on in: the one of its journal. What is asked for again must not
// contradict it, and nothing moves a real arm that was not asked to.
#pragma once

#include "app/cell_options.h"

namespace gripscan::app {

/// `journalled`: as the session began; `asked`: of the command line that resumes it, where the
/// defaults stand for what was not given. A cell file may say again where a real cell is now; the
/// speed may be another. Errors (input): another kind of cell, another mode, another step, seed or
/// fault, a LIVE session without --live.
[[nodiscard]] Result<CellOptions> resumed_cell(const CellOptions& journalled,
                                               const CellOptions& asked);

}  // namespace gripscan::app
