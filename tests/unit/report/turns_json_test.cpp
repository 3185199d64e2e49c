#include "core/report/turns_json.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/report/table1.h"
#include "tests/unit/report/sample_report.h"

namespace gripscan {
namespace {

using nlohmann::ordered_json;
using testing::ElementsAreArray;
using testing::HasSubstr;

std::vector<std::string> keys(const ordered_json& json) {
    std::vector<std::string> names;
    for (const auto& item : json.items()) names.push_back(item.key());
    return names;
}

/// The first fields, in order, are those of the contract; additions follow them.
void expect_begins_with(const ordered_json& json, std::vector<std::string> expected) {
    auto names = keys(json);
    ASSERT_GE(names.size(), expected.size());
    names.resize(expected.size());
    EXPECT_THAT(names, ElementsAreArray(expected));
}

TEST(TurnsJson, HasTheFieldsOfTheContractInOrder) {
    const auto json = ordered_json::parse(turns_json(test::sample_report(), {"/a/t.pcd", 2}));
    expect_begins_with(
        json, {"format", "sign_source", "limits", "steps", "axis", "closure", "poses", "template"});
    EXPECT_EQ(json["format"], "gripscan-turns/1");
    EXPECT_EQ(json["sign_source"], "joint");
    EXPECT_THAT(keys(json["limits"]),
                ElementsAreArray({"angle_deg", "sigmas", "overlap", "slip_mm", "tilt_deg"}));
    EXPECT_EQ(json["limits"]["angle_deg"], 0.5);
    expect_begins_with(json["steps"][0],
                       {"index",     "from",        "to",        "attempts",  "commanded_deg",
                        "robot_deg", "icp_deg",     "error_deg", "sigma_deg", "observability",
                        "mode",      "independent", "roll_deg",  "pitch_deg", "yaw_deg",
                        "x_m",       "y_m",         "z_m",       "tilt_deg",  "axis_offset_mm",
                        "slip_mm",   "T",           "overlap",   "rms_mm",    "verdict",
                        "cause"});
    EXPECT_THAT(keys(json["axis"]), ElementsAreArray({"point_m", "direction", "sd_deg", "sd_mm"}));
    EXPECT_EQ(json["template"]["path"], "/a/t.pcd");
    EXPECT_EQ(json["template"]["points"], 2);
    EXPECT_EQ(json["poses"].size(), 4u);
    EXPECT_TRUE(json["poses"][2].is_null());
    EXPECT_NEAR(json["closure"]["before"]["mm"].get<double>(), 1.2, 1e-12);
}

TEST(TurnsJson, UnknownNumbersAreNull) {
    TurnReport report = test::sample_report();
    report.steps[0].rms_m = std::numeric_limits<double>::quiet_NaN();
    report.closure_after.reset();
    report.axis.reset();
    const auto json = ordered_json::parse(turns_json(report, {"t.pcd", 2}));
    for (const char* key : {"icp_deg", "error_deg", "sigma_deg", "robot_deg", "T", "roll_deg",
                            "z_m", "overlap", "rms_mm", "tilt_deg", "slip_mm", "observability"}) {
        EXPECT_TRUE(json["steps"][2][key].is_null()) << key;
    }
    EXPECT_TRUE(json["steps"][0]["rms_mm"].is_null());
    EXPECT_TRUE(json["closure"].is_null());
    EXPECT_TRUE(json["axis"].is_null());
}

TEST(TurnsJson, NumbersAreWhole) {
    const TurnReport report = test::sample_report();
    const auto json = ordered_json::parse(turns_json(report, {"t.pcd", 2}));
    const auto& T = json["steps"][0]["T"];
    const auto expected = row_major_from_pose(*report.steps[0].T);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(T[i].get<double>(), expected[i]);
    EXPECT_EQ(json["steps"][0]["commanded_deg"].get<double>(), 10.0);
    EXPECT_NEAR(json["steps"][0]["roll_deg"].get<double>(), 9.98, 1e-12);
}

TEST(TurnsJson, ReadsWhatItWrites) {
    const TurnReport report = test::sample_report();
    const std::string text = turns_json(report, {"template.pcd", 2});
    const auto document = parse_turns_json("turns.json", text);
    ASSERT_TRUE(document) << document.error().message;
    EXPECT_EQ(turns_json(document->report, document->merged), text);
    EXPECT_EQ(table1_csv(table1_of(document->report, {})), table1_csv(table1_of(report, {})))
        << "a report made again shows the same numbers";
}

TEST(TurnsJson, SaysWhatIsWrongWithADocument) {
    const auto problem = [](const std::string& text) {
        const auto document = parse_turns_json("r/turns.json", text);
        return document ? std::string("no problem") : document.error().message;
    };
    EXPECT_THAT(problem("{"), HasSubstr("r/turns.json: not a JSON document"));
    EXPECT_THAT(problem("{\"format\": \"gripscan-turns/9\"}"), HasSubstr("gripscan-turns/9"));
    EXPECT_THAT(problem("{\"format\": 3}"), HasSubstr("format is 3"));
    std::string text = turns_json(test::sample_report(), {"t.pcd", 2});
    EXPECT_EQ(problem(text), "no problem");
    text.replace(text.find("\"reject\""), 8, "\"refuse\"");
    EXPECT_THAT(problem(text), HasSubstr("refuse"));
    EXPECT_THAT(problem("{\"format\": \"gripscan-turns/1\"}"), HasSubstr("not as expected"));
}

}  // namespace
}  // namespace gripscan
