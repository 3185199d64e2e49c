#include "core/report/template_json.h"

#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/checksum.h"
#include "core/base/units.h"
#include "core/report/json_parts.h"
#include "core/report/table1.h"

namespace gripscan {
namespace {

Result<Json> source(const Session& session, const std::string& relative) {
    const auto bytes = read_whole_file(session.file(relative));
    if (!bytes) return forward_error(bytes.error());
    return Json{{"file", relative}, {"check", checksum_text(*bytes)}};
}

std::vector<std::string> source_files(const Session& session) {
    std::vector<std::string> files{"session.yaml", "captures.csv"};
    if (session.rig) files.emplace_back("rig.yaml");
    for (const auto& row : session.table.rows) {
        if (row.status != CaptureStatus::kUsed) continue;
        if (Session::uses_images(row)) {
            files.push_back(row.left);
            files.push_back(row.right);
        } else {
            files.push_back(row.cloud);
        }
    }
    return files;
}

Json settings_json(const ComputeTurnSettings& settings) {
    const TurnSettings& turn = settings.turn;
    Json json{{"method", turn.method == TurnMethod::kTurn ? "turn" : "paper-icp"}};
    json["step_deg"] = json_deg(turn.step_rad);
    json["voxel_mm"] = json_mm(turn.voxel_m);
    json["min_seen"] = turn.min_seen;
    json["crop"] = settings.crop;
    json["limits"] = json_limits(turn.limits);
    if (turn.method == TurnMethod::kTurn) {
        json["seed"] = turn.align.seed;
        json["starts"] = turn.align.starts;
        json["start_cone_deg"] = json_deg(turn.align.start_cone_rad);
    } else {
        json["icp_max_correspondence_mm"] = json_mm(turn.paper_icp.max_correspondence_m);
        json["icp_iterations"] = turn.paper_icp.iterations;
        json["icp_voxel_mm"] = json_mm(turn.paper_icp.voxel_m);
    }
    return json;
}

Json table_json(const TurnReport& report) {
    const TurnSummary summary = summary_of(report);
    const bool compared = summary.compared > 0;
    const auto known = [&](double rad) { return compared ? json_deg(rad) : Json(nullptr); };
    return {{"file", "turns.csv"},
            {"steps", summary.steps},
            {"accepted", summary.accepted},
            {"check", summary.checks},
            {"rejected", summary.rejected},
            {"mean_abs_error_deg", known(summary.mean_abs_error_rad)},
            {"worst_abs_error_deg", known(summary.worst_abs_error_rad)}};
}

}  // namespace

Result<std::string> template_json(const TurnReport& report, const Provenance& from) {
    Json sources = Json::array();
    for (const auto& file : source_files(from.session)) {
        auto one = source(from.session, file);
        if (!one) return forward_error(one.error());
        sources.push_back(std::move(*one));
    }
    int first = 0;
    for (const auto& row : from.session.table.rows) {
        if (row.status != CaptureStatus::kUsed) continue;
        first = row.index;
        break;
    }
    Json json{{"format", "gripscan-template/1"}};
    json["file"] = "template.pcd";
    json["kind"] = word(from.session.spec.kind);
    json["unit"] = "m";
    json["frame"] = fmt::format("rectified left camera, part as in capture {}", first);
    json["points"] = report.merged.size();
    json["software"] = {{"name", "gripscan"}, {"version", from.version}};
    json["settings"] = settings_json(from.settings);
    json["closure"] = json_closure(report);
    json["table"] = table_json(report);
    json["sources"] = std::move(sources);
    return document_text(json);
}

}  // namespace gripscan
