// A recording as the window looks at it: computed once, never changed.
#pragma once

#include "app/workstation/seen_captures.h"
#include "core/base/for_each.h"

namespace gripscan::app {

struct RecordedTurn {
    ui::SessionFacts facts;
    std::optional<ProcedureState> state;  ///< nothing: a cloud alone
    std::vector<ui::ShownCapture> captures;
    std::shared_ptr<const ComputedTurn> solved;
    ui::CellFrame cell;

    void show_in(ui::Snapshot& snapshot) const;
};

/// A session folder: every used capture is made ready and the turn is solved, as a replay does it,
/// but nothing is written. Its state is that of its journal, where it has one; else that of its
/// results. Errors: as replay.
[[nodiscard]] Result<RecordedTurn> load_recorded_turn(const std::filesystem::path& folder,
                                                      const Progress& progress,
                                                      const ForEach& for_each);

/// A cloud file, as a template without a turn.
[[nodiscard]] Result<RecordedTurn> load_cloud_alone(const std::filesystem::path& file);

}  // namespace gripscan::app
