#include "app/results_of.h"

#include "core/cloud/cloud_file.h"
#include "core/report/results_folder.h"

namespace gripscan::app {
namespace fs = std::filesystem;

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
    auto merged = load_cloud(results / document->merged.path);
    if (!merged) return forward_error(merged.error());
    document->report.merged = std::move(*merged);
    return ResultsOf{std::move(*session), std::move(document->report)};
}

}  // namespace gripscan::app
