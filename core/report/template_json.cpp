#include "core/report/template_json.h"

#include <algorithm>
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

Json split_json(const ObjectSplitSettings& split) {
    return {{"trim", word(split.trim)},
            {"margins_low_mm", json_vector(kMmPerM * split.margins.low_m)},
            {"margins_high_mm", json_vector(kMmPerM * split.margins.high_m)},
            {"most_lost", split.most_lost}};
}

/// The gripper that held the object, and how: what tells whether a grasp is stale.
Json gripper_json(const GripperTemplate& gripper, const std::optional<HeldPose>& held) {
    Json json{{"file", gripper.file}, {"check", gripper.check}};
    json["T_gripper_object"] = held ? json_pose(held->T_gripper_object) : Json(nullptr);
    json["sd_deg"] = held ? json_deg(held->sd_rad) : Json(nullptr);
    json["sd_mm"] = held ? json_mm(held->sd_m) : Json(nullptr);
    json["captures"] = held ? held->captures : 0;
    return json;
}

Json axis_json(const std::optional<AxisEstimate>& axis) {
    if (!axis) return nullptr;
    return {{"point_m", json_vector(axis->axis.point_m)},
            {"direction", json_vector(axis->axis.direction)}};
}

/// Joint 6 at the capture whose frame the template has: the mean of the readings around it.
Json frame_joint6_json(const CaptureRow& first) {
    const auto& before = first.joints_deg[5];
    const auto& after = first.j6_after_deg;
    if (before && after) return json_number(0.5 * (*before + *after));
    return json_number(before ? before : after);
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
    const auto& rows = from.session.table.rows;
    const auto first = std::find_if(rows.begin(), rows.end(), [](const CaptureRow& row) {
        return row.status == CaptureStatus::kUsed;
    });
    if (first == rows.end()) return input_error("a template without used captures");
    Json json{{"format", "gripscan-template/1"}};
    json["file"] = "template.pcd";
    json["kind"] = word(from.session.spec.kind);
    json["unit"] = "m";
    json["frame"] = fmt::format("rectified left camera, part as in capture {}", first->index);
    json["axis"] = axis_json(report.axis);
    json["frame_joint6_deg"] = frame_joint6_json(*first);
    json["points"] = report.merged.size();
    json["software"] = {{"name", "gripscan"}, {"version", from.version}};
    json["settings"] = settings_json(from.settings);
    if (from.settings.gripper) {
        json["split"] = split_json(from.settings.split);
        json["gripper"] = gripper_json(*from.settings.gripper, from.held);
    }
    json["closure"] = json_closure(report);
    json["table"] = table_json(report);
    json["sources"] = std::move(sources);
    return document_text(json);
}

}  // namespace gripscan
