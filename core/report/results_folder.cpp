#include "core/report/results_folder.h"

#include <unistd.h>

#include <algorithm>
#include <array>

#include "core/base/atomic_file.h"
#include "core/cloud/cloud_file.h"
#include "core/report/html_page.h"
#include "core/report/table1.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kFiles{"turns.csv", "turns.json", "template.pcd",
                                                 "template.json", "report.html"};

/// The name people gave the session: that of its folder.
std::string session_name(const Session& session) {
    std::error_code code;
    fs::path path = fs::absolute(session.folder, code).lexically_normal();
    if (path.filename().empty()) path = path.parent_path();
    return path.filename().string();
}

bool is_within(const fs::path& inner, const fs::path& outer) {
    const auto [end, rest] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
    static_cast<void>(rest);
    return end == outer.end();
}

fs::path plain_path(const fs::path& path) {
    std::error_code code;
    fs::path result = fs::weakly_canonical(fs::absolute(path, code), code);
    if (result.filename().empty()) result = result.parent_path();
    return result;
}

/// The nearest folder above that exists has to be one we may write to.
Status check_writable(const fs::path& out) {
    std::error_code code;
    fs::path parent = out.parent_path();
    while (!fs::exists(parent, code) && parent != parent.parent_path()) {
        parent = parent.parent_path();
    }
    if (!fs::is_directory(parent, code)) {
        return input_error("cannot write to {}: {} is not a folder", out.string(), parent.string());
    }
    if (::access(parent.c_str(), W_OK | X_OK) != 0) {
        return input_error("cannot write to {}: no permission to write in {}", out.string(),
                           parent.string());
    }
    return {};
}

}  // namespace

Status check_results_target(const fs::path& session, const fs::path& out_given) {
    const fs::path out = plain_path(out_given);
    std::error_code code;
    if (fs::is_symlink(out, code)) {
        return input_error("cannot write results to {}: the link leads nowhere", out.string());
    }
    if (out == plain_path(".")) {
        return input_error(
            "results replace a folder as a whole, so not the current one, {}; name a folder in it",
            out.string());
    }
    if (is_within(plain_path(session), out)) {
        return input_error("results cannot replace {}: it holds the session {}", out.string(),
                           session.string());
    }
    if (fs::exists(out, code) && !fs::is_directory(out, code)) {
        return input_error("cannot write results to {}: it is a file, not a folder", out.string());
    }
    if (Status status = check_writable(out); !status) return status;
    for (const auto& entry : fs::directory_iterator(out, code)) {
        const std::string name = entry.path().filename().string();
        if (std::find(kFiles.begin(), kFiles.end(), name) == kFiles.end()) {
            return input_error("results would replace {}, which holds '{}'; choose a new folder",
                               out.string(), name);
        }
    }
    return {};
}

ReportFiles report_files(const TurnReport& report, std::size_t template_points,
                         const Session& session, const std::string& version) {
    const Table1 table = table1_of(report, session.table);
    return {table1_csv(table),
            html_page({report, table, session_name(session), template_points, version})};
}

Status write_results(const fs::path& out, const TurnReport& report, const Provenance& from) {
    const auto sidecar = template_json(report, from);
    if (!sidecar) return forward_error(sidecar.error());
    const std::size_t points = report.merged.size();
    const ReportFiles files = report_files(report, points, from.session, from.version);
    // A link keeps leading to its folder; it is the folder that is replaced.
    return replace_folder_atomically(plain_path(out), [&](const fs::path& fresh) -> Status {
        if (Status s = save_cloud(fresh / "template.pcd", report.merged); !s) return s;
        if (Status s = write_file_atomically(fresh / "template.json", *sidecar); !s) return s;
        if (Status s = write_file_atomically(fresh / "turns.csv", files.csv); !s) return s;
        if (Status s = write_file_atomically(fresh / "report.html", files.html); !s) return s;
        return write_file_atomically(fresh / "turns.json",
                                     turns_json(report, {"template.pcd", points}));
    });
}

Result<TurnsDocument> load_results(const fs::path& results) {
    const fs::path path = results / "turns.json";
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    return parse_turns_json(path, *text);
}

}  // namespace gripscan
