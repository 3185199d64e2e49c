// What the pages beside the procedure may be shown with: sessions, a template, a checked cell.
#pragma once

#include "ui/views/snapshot.h"

namespace gripscan::test {

/// The eight lines of the start page, an interrupted session first.
[[nodiscard]] std::vector<ui::RecentSession> sample_recent();

/// The same template in every run: a can of points, filtered as `filter` says.
[[nodiscard]] ui::ShownTemplate sample_template(const TemplateFilter& filter);

enum class SampleCell { kNotChecked, kPassed, kFailed };
/// A connected simulated cell before its first view.
[[nodiscard]] ProcedureState sample_cell_state(SampleCell outcome);
[[nodiscard]] ui::CellFrame sample_cell_frame();

[[nodiscard]] std::vector<ui::KeyBinding> sample_keys();

/// The template page of a complete session, every filter on.
[[nodiscard]] ui::Snapshot sample_template_page();
/// A gripper and an object found in one view.
[[nodiscard]] ui::Snapshot sample_recognised();

}  // namespace gripscan::test
