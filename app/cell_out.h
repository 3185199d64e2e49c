// What a simulated cell writes: cell.yaml and the rig that it names, by which others find it, and
// the truth.
#pragma once

#include <filesystem>

#include "app/context.h"
#include "core/sim/sim_cell.h"

namespace gripscan::app {

/// Into the folder, which is made if needed. The cell must serve frames.
[[nodiscard]] Status write_cell_files(const SimCell& cell, const std::filesystem::path& folder);

/// The truth of the captures that were grabbed. Where there were none this is said, and nothing is
/// written.
[[nodiscard]] Status write_truth(const SimCell& cell, const std::filesystem::path& folder,
                                 const Context& context);

}  // namespace gripscan::app
