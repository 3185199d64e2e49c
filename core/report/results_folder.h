// The results folder: turns.csv, turns.json, template.pcd, template.json, report.html, and nothing
// else. It appears as a whole or not at all.
#pragma once

#include <filesystem>

#include "core/report/template_json.h"
#include "core/report/turns_json.h"

namespace gripscan {

/// Whether results may go there, asked before the work begins. The folder is replaced, so one that
/// holds anything but results, and the session itself, are errors.
[[nodiscard]] Status check_results_target(const std::filesystem::path& session,
                                          const std::filesystem::path& out);

[[nodiscard]] Status write_results(const std::filesystem::path& out, const TurnReport& report,
                                   const Provenance& from);

/// turns.csv and report.html of stored results, made again.
struct ReportFiles {
    std::string csv;
    std::string html;
};
[[nodiscard]] ReportFiles report_files(const TurnReport& report, std::size_t template_points,
                                       const Session& session, const std::string& version);

/// What a results folder says: turns.json in it.
[[nodiscard]] Result<TurnsDocument> load_results(const std::filesystem::path& results);

}  // namespace gripscan
