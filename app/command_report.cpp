#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/results_of.h"
#include "core/base/atomic_file.h"
#include "core/report/report_json.h"
#include "core/report/results_folder.h"
#include "core/report/table1_text.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

struct ReportOptions {
    std::string session;
    std::string out;
};

Status write_report(const fs::path& out, const ReportFiles& files) {
    std::error_code code;
    fs::create_directories(out, code);
    if (!fs::is_directory(out, code)) return input_error("cannot make the folder {}", out.string());
    if (Status s = write_file_atomically(out / "turns.csv", files.csv); !s) return s;
    return write_file_atomically(out / "report.html", files.html);
}

Result<ExitStatus> report(const ReportOptions& options, const Context& context) {
    const fs::path session = options.session;
    const auto results = results_of(session, context);
    if (!results) return forward_error(results.error());
    if (context.stop.stop_requested()) return cancelled_error();
    const TurnReport& turn = results->report;
    const fs::path out =
        absolute_path(options.out.empty() ? session / "results" : fs::path(options.out));
    const ReportFiles files =
        report_files(turn, turn.merged.size(), results->session, GRIPSCAN_VERSION);
    if (Status written = write_report(out, files); !written) return forward_error(written.error());
    const std::string csv = (out / "turns.csv").string();
    const std::string html = (out / "report.html").string();
    if (context.options.json) {
        print_result(report_json(turn, csv, html));
    } else if (!context.options.quiet) {
        print_result(table1_text(turn, table1_of(turn, results->session.table)));
        print_result(fmt::format("table        {}\nreport       {}\n", csv, html));
    }
    return trust(turn);
}

}  // namespace

void add_report(const CommandLine& line) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* command = line.app.add_subcommand("report", "Table 1 as CSV and as an HTML page");
    command->add_option("session", options->session, "Session folder")
        ->required()
        ->option_text("SESSION");
    command->add_option("--out", options->out, "Folder to write into (SESSION/results)")
        ->option_text("DIR");
    add_common_options(*command, line.common);
    command->footer(
        "Takes the results of the session; computes them where there are none.\n"
        "Example:\n  gripscan report monday --out /tmp/hand-over");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return report(*options, context); };
    });
}

}  // namespace gripscan::app
