#include "app/turn_work.h"

#include "app/console.h"
#include "app/progress_bar.h"
#include "app/session_settings.h"
#include "app/threads.h"
#include "core/report/results_folder.h"
#include "core/report/table1_text.h"

namespace gripscan::app {
namespace fs = std::filesystem;

Result<TurnWork> compute_session(const fs::path& folder, const TurnOptions& options,
                                 const Context& context) {
    auto session = open_session(folder);
    if (!session) return forward_error(session.error());
    if (session->spec.kind != SessionKind::kGripper && session->spec.kind != SessionKind::kObject) {
        return input_error("{}: a session of kind {} is no turn; kinds gripper and object are",
                           (folder / "session.yaml").string(), word(session->spec.kind));
    }
    auto settings = session_settings(*session, options);
    if (!settings) return forward_error(settings.error());
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    const Progress progress = bar.progress();
    if (Status checked = check_session_files(*session, progress, pool.for_each()); !checked) {
        return forward_error(checked.error());
    }
    auto computed = compute_turn(recording_of(*session), *settings, progress, pool.for_each());
    if (!computed) return forward_error(computed.error());
    return TurnWork{std::move(*session), std::move(*settings), std::move(*computed)};
}

Result<ExitStatus> deliver(const TurnWork& work, const fs::path& out, const Context& context) {
    if (context.stop.stop_requested()) return cancelled_error();
    const TurnReport& report = work.computed.report;
    const Provenance from{work.session, work.settings, GRIPSCAN_VERSION, work.computed.held};
    if (Status written = write_results(out, report, from); !written) {
        return forward_error(written.error());
    }
    return tell_results(work, out, context);
}

ExitStatus tell_results(const TurnWork& work, const fs::path& out, const Context& context) {
    const TurnReport& report = work.computed.report;
    const fs::path merged = absolute_path(out) / "template.pcd";
    if (context.options.json) {
        print_result(turns_json(report, {merged.string(), report.merged.size()}));
    } else if (!context.options.quiet) {
        print_result(table1_text(report, table1_of(report, work.session.table)));
        print_result(fmt::format("template     {} ({} points)\ntable        {}\nreport       {}\n",
                                 merged.string(), report.merged.size(),
                                 (absolute_path(out) / "turns.csv").string(),
                                 (absolute_path(out) / "report.html").string()));
    }
    return trust(report);
}

ExitStatus trust(const TurnReport& report) {
    return all_trusted(report) ? kDone : kNotTrusted;
}

fs::path absolute_path(const fs::path& path) {
    std::error_code code;
    fs::path result = fs::absolute(path, code).lexically_normal();
    if (result.filename().empty()) result = result.parent_path();
    return result;
}

}  // namespace gripscan::app
