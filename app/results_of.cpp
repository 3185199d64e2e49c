#include "app/results_of.h"

#include <vector>

#include "core/cloud/cloud_file.h"
#include "core/report/results_folder.h"

namespace gripscan::app {
namespace fs = std::filesystem;
namespace {

/// Are the steps those between the rows that are used now? Someone may have excluded a capture
/// since.
bool still_holds(const TurnReport& report, const CaptureTable& table) {
    std::vector<int> used;
    for (const auto& row : table.rows) {
        if (row.status == CaptureStatus::kUsed) used.push_back(row.index);
    }
    if (report.poses.size() != table.rows.size()) return false;
    if (report.steps.size() + 1 != used.size()) return false;
    for (std::size_t i = 0; i < report.steps.size(); ++i) {
        const TurnStep& step = report.steps[i];
        if (step.from != used[i] || step.to != used[i + 1]) return false;
    }
    return true;
}

}  // namespace

Result<ResultsOf> results_of(const fs::path& folder, const Context& context) {
    const fs::path results = folder / "results";
    std::error_code code;
    if (!fs::exists(results / "turns.json", code)) {
        auto work = compute_session(folder, TurnOptions{}, context);
        if (!work) return forward_error(work.error());
        return ResultsOf{std::move(work->session), std::move(work->computed.report)};
    }
    auto session = open_session(folder);
    if (!session) return forward_error(session.error());
    auto document = load_results(results);
    if (!document) return forward_error(document.error());
    if (!still_holds(document->report, session->table)) {
        return input_error(
            "{} was computed from other captures than {} uses now; compute it again with "
            "`gripscan replay`",
            results.string(), (folder / "captures.csv").string());
    }
    auto merged = load_cloud(results / document->merged.path);
    if (!merged) return forward_error(merged.error());
    document->report.merged = std::move(*merged);
    return ResultsOf{std::move(*session), std::move(document->report)};
}

}  // namespace gripscan::app
