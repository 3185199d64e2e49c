#include "core/report/exam_json.h"

#include "core/report/json_parts.h"

namespace gripscan {
namespace {

Json answer_json(const ExamAnswer& a) {
    const auto measure = [&](double PoseMeasures::*value) {
        return a.measures ? json_mm((*a.measures).*value) : Json(nullptr);
    };
    Json json{{"capture", a.capture}, {"joint_deg", json_deg(a.joint_rad)}};
    json["found"] = a.T_estimated.has_value();
    json["score"] = json_number(a.score);
    json["T_camera_template"] = json_pose(a.T_estimated);
    json["T_expected"] = json_pose(a.T_expected);
    json["error_deg"] = a.measures ? json_deg(a.measures->turn_rad) : Json(nullptr);
    json["add_mm"] = measure(&PoseMeasures::add_m);
    json["add_s_mm"] = measure(&PoseMeasures::add_s_m);
    json["mssd_mm"] = measure(&PoseMeasures::mssd_m);
    json["passed"] = a.passed;
    return json;
}

}  // namespace

std::string exam_json(const ExamResult& exam) {
    Json answers = Json::array();
    for (const ExamAnswer& a : exam.answers) answers.push_back(answer_json(a));
    Json json{{"format", "gripscan-exam/1"}};
    json["passed"] = exam.passed;
    json["sentence"] = exam.sentence;
    json["answers"] = std::move(answers);
    return document_text(json);
}

}  // namespace gripscan
