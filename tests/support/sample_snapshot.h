// Snapshots of the window as a turn passes through its states, with numbers like those of a real
// one: for tests and pictures of panels.
#pragma once

#include <memory>
#include <vector>

#include "ui/views/snapshot.h"

namespace gripscan::test {

/// A snapshot and what it points at.
struct Sample {
    std::shared_ptr<ProcedureState> state;
    std::shared_ptr<std::vector<ui::LogLine>> log;
    ui::Snapshot snapshot;
};

/// A session in the simulated cell, not connected yet.
[[nodiscard]] Sample sample_empty();
/// Connected, the cell checked with one warning; the axis is next.
[[nodiscard]] Sample sample_cell_checked();
/// Step 14 of 36, all accepted but step 11, which is Check.
[[nodiscard]] Sample sample_running();
/// Step 6 rejected: 24.3° against 10°, overlap too low; halving is advised.
[[nodiscard]] Sample sample_rejected();
/// 36 steps, solved and closed.
[[nodiscard]] Sample sample_finished();
/// The link was lost in step 9: interrupted, with an error.
[[nodiscard]] Sample sample_link_lost();

/// Step 14 going on by itself: aligning, with a job.
[[nodiscard]] Sample sample_aligning();
/// The same cell as the others, in another mode.
void set_mode(Sample& sample, MotionMode mode);

}  // namespace gripscan::test
