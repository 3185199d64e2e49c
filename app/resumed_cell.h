// Which cell a resumed session goes on in: the one of its journal. What is asked for again must not
// contradict it, and nothing moves a real arm that was not asked to.
#pragma once

#include <filesystem>
#include <set>

#include "app/cell_options.h"

namespace gripscan::app {

/// Names of options that were given, where a default and the same given by hand differ.
using GivenOptions = std::set<std::string, std::less<>>;

/// Of a command line that has been parsed: those of add_cell_options() that were given.
[[nodiscard]] GivenOptions given_cell_options(const CLI::App& command);

/// `journalled`: as the session began; `asked`: of the command line that resumes it, and which of
/// its options were given. A cell file may say again where a real cell is now; the speed may be
/// another. Errors (input): another kind of cell, another mode, another step, seed or fault, a LIVE
/// session without --live.
[[nodiscard]] Result<CellOptions> resumed_cell(const CellOptions& journalled,
                                               const CellOptions& asked, const GivenOptions& given);

/// Can the cell file be read that the session's journal names? The message says what to do where it
/// has moved.
[[nodiscard]] Status check_cell_file(const std::filesystem::path& session,
                                     const CellOptions& resumed);

}  // namespace gripscan::app
