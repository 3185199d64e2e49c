// Which cell a run talks to, and with which rights: options of the command line, and part of what a
// session remembers.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/procedure/journal.h"
#include "core/procedure/turn_plan.h"

namespace gripscan::app {

struct CellOptions {
    std::string cell = "sim";  ///< a cell file, or "sim"
    bool live = false;         ///< motions of a real controller are sent
    bool manual = false;       ///< no motion rights
    std::optional<double> speed_percent;
    double step_deg = 10.0;

    // Of the simulated cell.
    std::uint64_t seed = 1;
    std::string gripper_model;
    std::string object;  ///< in the simulated gripper; empty: nothing
    std::vector<std::string> faults;
    bool arm_away = false;  ///< out of the picture, as for learning the environment
    /// Joints 1 … 5 elsewhere than a registration wants them; not remembered.
    std::optional<std::array<double, 5>> other_joints_deg;

    [[nodiscard]] bool simulated() const { return cell == "sim"; }
    [[nodiscard]] MotionMode mode() const;
};

void add_cell_options(CLI::App& command, CellOptions& options);
/// What the simulated gripper holds.
void add_object_option(CLI::App& command, CellOptions& options);

/// Combinations that make no sense: --live of the simulated cell, seeds of a real one, …
[[nodiscard]] Status check(const CellOptions& options);

/// As an entry of the journal, and back.
[[nodiscard]] JournalFields journal_fields(const CellOptions& options);
[[nodiscard]] Result<CellOptions> cell_options_from(const JournalFields& fields);

}  // namespace gripscan::app
