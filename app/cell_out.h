// The files by which others find a simulated cell: cell.yaml and the rig that it names.
#pragma once

#include <filesystem>

#include "core/sim/sim_cell.h"

namespace gripscan::app {

/// Into the folder, which is made if needed. The cell must serve frames.
[[nodiscard]] Status write_cell_files(const SimCell& cell, const std::filesystem::path& folder);

}  // namespace gripscan::app
