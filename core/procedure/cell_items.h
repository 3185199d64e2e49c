// The items of the cell check, by what they are about. All pure.
#pragma once

#include <string>
#include <vector>

#include "core/procedure/cell_facts.h"
#include "core/procedure/cell_limits.h"
#include "core/procedure/cell_report.h"
#include "core/procedure/turn_plan.h"

namespace gripscan {

[[nodiscard]] CellCheckItem skipped(std::string name, std::string unit, const std::string& why);
[[nodiscard]] CellCheckItem at_most(std::string name, double value, double limit, std::string unit);
[[nodiscard]] CellCheckItem at_least(std::string name, double value, double limit,
                                     std::string unit);
/// What was found, and, unless it passed, what to do.
[[nodiscard]] CellCheckItem with_sentence(CellCheckItem item, std::string found,
                                          std::string_view what_to_do);

[[nodiscard]] CellCheckItem link_item(const CellFacts& facts, const CellLimits& limits);
[[nodiscard]] CellCheckItem controller_item(const CellFacts& facts, const TurnPlan& plan);
[[nodiscard]] CellCheckItem joints_item(const CellFacts& facts);
/// range, cable, return.
[[nodiscard]] std::vector<CellCheckItem> turn_items(const CellFacts& facts, const TurnPlan& plan,
                                                    const CellLimits& limits);

[[nodiscard]] CellCheckItem volume_item(const CellFacts& facts, const CellLimits& limits);
[[nodiscard]] CellCheckItem depth_item(const CellFacts& facts, const CellLimits& limits);
/// exposure, brightness, texture, fill, surface.
[[nodiscard]] std::vector<CellCheckItem> image_items(const CellFacts& facts,
                                                     const CellLimits& limits);

[[nodiscard]] CellCheckItem alone_item(const CellFacts& facts, const CellLimits& limits);
[[nodiscard]] CellCheckItem joint_item(const CellFacts& facts, const CellLimits& limits);
[[nodiscard]] CellCheckItem sweep_item(const CellFacts& facts, const CellLimits& limits);

[[nodiscard]] CellCheckItem disk_item(const CellFacts& facts, const TurnPlan& plan);
[[nodiscard]] CellCheckItem duration_item(const CellFacts& facts, const TurnPlan& plan,
                                          const CellLimits& limits);

}  // namespace gripscan
