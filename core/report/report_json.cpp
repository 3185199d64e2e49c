#include "core/report/report_json.h"

#include "core/report/json_parts.h"
#include "core/report/table1.h"

namespace gripscan {

std::string report_json(const TurnReport& report, const std::string& csv_path,
                        const std::string& html_path) {
    const TurnSummary summary = summary_of(report);
    const auto known = [&](double rad) {
        return summary.compared > 0 ? json_deg(rad) : Json(nullptr);
    };
    Json json{{"format", "gripscan-report/1"}};
    json["table"] = csv_path;
    json["page"] = html_path;
    json["steps"] = summary.steps;
    json["accepted"] = summary.accepted;
    json["check"] = summary.checks;
    json["rejected"] = summary.rejected;
    json["mean_abs_error_deg"] = known(summary.mean_abs_error_rad);
    json["worst_abs_error_deg"] = known(summary.worst_abs_error_rad);
    json["closure"] = json_closure(report);
    return document_text(json);
}

std::string export_json(const std::string& path, std::size_t points, std::string_view unit,
                        std::string_view frame) {
    Json json{{"format", "gripscan-export/1"}};
    json["path"] = path;
    json["points"] = points;
    json["unit"] = unit;
    json["frame"] = frame;
    return document_text(json);
}

}  // namespace gripscan
