// Views of a template at held-out angles: from a recording, or taken of the cell for this.
#pragma once

#include <optional>
#include <vector>

#include "app/cell_options.h"
#include "app/context.h"
#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/cloud/cloud.h"
#include "core/session/session.h"

namespace gripscan::app {

struct ExamView {
    int capture = 0;
    double joint6_rad = 0.0;
    Cloud cloud;
};

/// The captures named; without any, those that the session excludes. Joint 6 must be recorded.
[[nodiscard]] Result<std::vector<ExamView>> recorded_exam(const Session& session,
                                                          const std::vector<int>& captures,
                                                          const Progress& progress,
                                                          const ForEach& for_each);

struct ExamDrive {
    CellOptions cell;
    int angles = 8;
    std::uint64_t seed = 1;
};

/// Drives joint 6 to random angles, none within 2° of one that the template is made of, and takes
/// a view at each.
[[nodiscard]] Result<std::vector<ExamView>> driven_exam(const Session& session,
                                                        const ExamDrive& drive,
                                                        const Context& context,
                                                        const Progress& progress,
                                                        const ForEach& for_each);

/// Mean of the readings around the exposure, rad; nothing where there are none.
[[nodiscard]] std::optional<double> joint6_rad(const CaptureRow& row);

}  // namespace gripscan::app
