// The options of how a turn is computed, shared by replay and run.
#pragma once

#include <CLI/CLI.hpp>

#include "core/procedure/compute_turn.h"

namespace gripscan::app {

/// The paper's ICP on the command line, in its units.
struct PaperIcpOptions {
    double max_correspondence_mm = 50.0;
    int iterations = 10;
    double voxel_mm = 0.0;
    [[nodiscard]] PaperIcpSettings settings() const;
};

struct TurnOptions {
    TurnMethod method = TurnMethod::kTurn;
    PaperIcpOptions icp;
    bool no_crop = false;
    TrimBy trim = TrimBy::kAuto;  ///< of an object's turn
    /// Changes the settings that the session gave.
    void apply_to(ComputeTurnSettings& settings) const;
};

void add_method_options(CLI::App& command, TurnMethod& method, PaperIcpOptions& icp);
void add_turn_options(CLI::App& command, TurnOptions& options);

}  // namespace gripscan::app
