#include "core/procedure/cell_check.h"

#include <iterator>
#include <utility>

#include "core/procedure/cell_items.h"

namespace gripscan {
namespace {

void append(std::vector<CellCheckItem>& items, std::vector<CellCheckItem> more) {
    items.insert(items.end(), std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
}

}  // namespace

CellCheckItem skipped(std::string name, std::string unit, const std::string& why) {
    return {std::move(name), CheckOutcome::kSkipped, 0.0, 0.0,
            std::move(unit), "not measured: " + why};
}

CellCheckItem at_most(std::string name, double value, double limit, std::string unit) {
    return {std::move(name), value <= limit ? CheckOutcome::kPassed : CheckOutcome::kFailed,
            value,           limit,
            std::move(unit), {}};
}

CellCheckItem at_least(std::string name, double value, double limit, std::string unit) {
    return {std::move(name), value >= limit ? CheckOutcome::kPassed : CheckOutcome::kFailed,
            value,           limit,
            std::move(unit), {}};
}

CellCheckItem with_sentence(CellCheckItem item, std::string found, std::string_view what_to_do) {
    item.sentence = std::move(found);
    if (item.outcome != CheckOutcome::kPassed) item.sentence.append("; ").append(what_to_do);
    return item;
}

CellReport assess(const CellFacts& facts, const TurnPlan& plan, const CellLimits& limits) {
    CellReport report;
    report.items = {link_item(facts, limits), controller_item(facts, plan), joints_item(facts)};
    append(report.items, turn_items(facts, plan, limits));
    append(report.items, {volume_item(facts, limits), depth_item(facts, limits)});
    append(report.items, image_items(facts, limits));
    append(report.items,
           {alone_item(facts, limits), joint_item(facts, limits), sweep_item(facts, limits),
            disk_item(facts, plan), duration_item(facts, plan, limits)});
    return report;
}

}  // namespace gripscan
