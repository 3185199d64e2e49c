#include "ui/views/recognition_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "ui/theme/shown_number.h"
#include "ui/views/cell_view.h"

namespace gripscan::ui {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::quiet_NaN();
/// Half a degree between joint and gripper: ten times what a single view usually shows.
constexpr double kWitness_deg = 0.5;

constexpr std::array<ColumnText, 11> kPoseColumns{{{"template", "", 190, 0, true, true},
                                                   {"in frame", "", 84, 0, false, true},
                                                   {"X mm", "Position", 84},
                                                   {"Y mm", "Position", 84},
                                                   {"Z mm", "Position", 84},
                                                   {"W °", "Rz(R) Ry(P) Rx(W)", 84, 4},
                                                   {"P °", "Rz(R) Ry(P) Rx(W)", 84, 5},
                                                   {"R °", "Rz(R) Ry(P) Rx(W)", 84, 6},
                                                   {"score", "Fit", 60, 2},
                                                   {"seen %", "Fit", 60, 1},
                                                   {"RMS mm", "Fit", 66, 3}}};

RowText pose_row(std::string name, std::string_view frame, const Pose& T, Emphasis emphasis) {
    RowText row;
    row.cells.push_back({std::move(name), Emphasis::kStrong});
    row.cells.push_back({std::string(frame),
                         emphasis == Emphasis::kStrong ? Emphasis::kStrong : Emphasis::kSecond});
    // Strong is for words: numbers that matter are those that are not grey.
    const Emphasis tone = emphasis == Emphasis::kStrong  ? Emphasis::kNormal
                          : emphasis == Emphasis::kThird ? Emphasis::kThird
                                                         : Emphasis::kSecond;
    for (const double number : tool_numbers(T)) {
        row.cells.push_back({shown_number(number, 2), tone});
    }
    row.cells.resize(kPoseColumns.size());
    return row;
}

void add_fit(RowText& row, const FoundTemplate& found) {
    row.cells[8] = {shown_number(found.score, 2), Emphasis::kNormal};
    row.cells[9] = {shown_number(100.0 * found.found, 0), Emphasis::kNormal};
    row.cells[10] = {shown_number(kMmPerM * found.rms_m, 2), Emphasis::kNormal};
}

std::string names_of(const std::vector<FoundTemplate>& found) {
    std::string names;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i > 0) names += i + 1 == found.size() ? " and " : ", ";
        names += found[i].name;
    }
    return names;
}

EvidenceText evidence(std::string_view id, std::string_view label, double value,
                      std::string_view unit, int decimals, double limit, bool at_least,
                      std::string_view meaning) {
    EvidenceText e;
    e.id = id;
    e.label = label;
    e.value = value;
    e.unit = unit;
    e.decimals = decimals;
    e.limit = limit;
    e.limit_decimals = decimals;
    e.at_least = at_least;
    e.meaning = meaning;
    const bool inside = at_least ? value >= limit : value <= limit;
    e.state = std::isnan(limit) || inside ? State::kAccept : State::kCheck;
    return e;
}

}  // namespace

Colour Theme::*colour_of_found(const ShownRecognition& shown, std::size_t i) {
    if (shown.found[i].kind == TemplateKind::kGripper) return &Theme::gripper;
    const auto objects_before =
        std::count_if(shown.found.begin(), shown.found.begin() + static_cast<long>(i),
                      [](const FoundTemplate& f) { return f.kind == TemplateKind::kObject; });
    if (objects_before == 0) return &Theme::object;
    return objects_before % 2 == 1 ? &Theme::source_safe : &Theme::target_safe;
}

RecognitionVerdict recognition_verdict(const Snapshot& snapshot) {
    const auto& shown = snapshot.recognition;
    if (!shown) {
        if (snapshot.library.empty()) {
            return {State::kWaiting, "The library is empty",
                    "Add the template of a finished turn, or a CAD mesh."};
        }
        return {State::kWaiting, "Nothing looked for yet",
                fmt::format("`{}` templates are in the library.", snapshot.library.size())};
    }
    if (!shown->strangers.empty()) {
        return {State::kCheck, "Not clear", shown->strangers.front()};
    }
    if (shown->found.empty()) {
        return {State::kCheck, "Nothing found",
                fmt::format("None of `{}` templates explains what this view shows.",
                            shown->looked_for)};
    }
    std::string sentence =
        fmt::format("{} found, of `{}` templates.", names_of(shown->found), shown->looked_for);
    const auto close = std::ranges::find_if(
        shown->found, [](const FoundTemplate& f) { return f.next_score.has_value(); });
    if (close != shown->found.end()) {
        sentence += fmt::format(" {} fits nearly as well in another pose: look before you grasp.",
                                close->name);
        return {State::kCheck, "Found, not unique", sentence};
    }
    if (shown->grasp && !shown->grasp->reachable) {
        return {State::kCheck, "Found, out of reach", shown->grasp->sentence};
    }
    if (shown->grasp) sentence += fmt::format(" {}", shown->grasp->sentence);
    return {State::kAccept, "Found", sentence};
}

std::vector<EvidenceText> found_evidence(const ShownRecognition& shown, std::size_t i) {
    const FoundTemplate& f = shown.found[i];
    return {evidence("found.score", "Score", f.score, "", 2, shown.least_score, true,
                     "Found surface times what speaks against the pose; below the limit a "
                     "template counts as absent"),
            evidence("found.seen", "Visible part seen", 100.0 * f.found, "%", 0,
                     100.0 * shown.least_found, true,
                     "Share of the surface that faces the camera and was measured where it "
                     "should be; the rest is hidden or not measured"),
            evidence("found.support", "Agrees", 100.0 * f.support, "%", 0, kNoLimit, true,
                     "Of what the camera could judge, the share that does not contradict"),
            evidence("found.outline", "Outline seen", 100.0 * f.outline, "%", 0, kNoLimit, true,
                     "Share of the predicted outline where the scene ends or bends too"),
            evidence("found.rms", "Residual RMS", kMmPerM * f.rms_m, "mm", 2,
                     kMmPerM * f.tolerance_m, false,
                     "Of the matched points along the normal; the limit is within what a point "
                     "counts as on the surface")};
}

std::vector<std::pair<std::string, std::string>> found_remarks(const FoundTemplate& found) {
    std::vector<std::pair<std::string, std::string>> remarks;
    if (found.symmetry != "none") remarks.emplace_back("Symmetry", found.symmetry);
    if (found.next_score) {
        remarks.emplace_back("Next best pose",
                             fmt::format("score {}", shown_number(*found.next_score, 2)));
    }
    return remarks;
}

TableText poses_text(const ShownRecognition& shown) {
    TableText text{kPoseColumns, {}, {}};
    for (const FoundTemplate& f : shown.found) {
        RowText first = pose_row(f.name, "camera", f.T_camera_template, Emphasis::kNormal);
        add_fit(first, f);
        text.rows.push_back(std::move(first));
        if (f.T_gripper_template) {
            const bool self = f.kind == TemplateKind::kGripper;
            text.rows.push_back(pose_row("", "gripper", *f.T_gripper_template,
                                         self ? Emphasis::kThird : Emphasis::kNormal));
        }
        if (f.T_robot_template) {
            text.rows.push_back(pose_row("", "robot", *f.T_robot_template, Emphasis::kStrong));
        }
    }
    if (shown.grasp) {
        text.last_rows.push_back(pose_row(fmt::format("Grasp of {}", shown.grasp->object), "robot",
                                          shown.grasp->T_robot_gripper, Emphasis::kStrong));
    }
    return text;
}

std::string poses_for_clipboard(const ShownRecognition& shown) {
    std::string text = "template\tframe\tx_mm\ty_mm\tz_mm\tw_deg\tp_deg\tr_deg\tscore\trms_mm\n";
    const auto add = [&](const FoundTemplate& f, std::string_view frame, const Pose& T) {
        text += fmt::format("{}\t{}", f.name, frame);
        for (const double number : tool_numbers(T))
            text += fmt::format("\t{}", text_from_number(number));
        text += fmt::format("\t{}\t{}\n", text_from_number(f.score),
                            text_from_number(kMmPerM * f.rms_m));
    };
    for (const FoundTemplate& f : shown.found) {
        add(f, "camera", f.T_camera_template);
        if (f.T_gripper_template) add(f, "gripper", *f.T_gripper_template);
        if (f.T_robot_template) add(f, "robot", *f.T_robot_template);
    }
    return text;
}

std::optional<WitnessText> witness_of(const Snapshot& snapshot) {
    const auto& shown = snapshot.recognition;
    if (!shown || !shown->joint6_robot_rad || !shown->joint6_gripper_rad) return std::nullopt;
    const double robot_deg = deg_from_rad(*shown->joint6_robot_rad);
    const double gripper_deg = deg_from_rad(*shown->joint6_gripper_rad);
    const double difference_deg = std::remainder(gripper_deg - robot_deg, 360.0);
    return WitnessText{shown_number(robot_deg, 3), shown_number(robot_deg + difference_deg, 3),
                       shown_number(difference_deg, 3, Sign::kAlways),
                       std::abs(difference_deg) <= kWitness_deg ? State::kAccept : State::kCheck};
}

std::string view_words(const ShownRecognition& shown) {
    return fmt::format("view {}, {} of {} templates found", shown.view, shown.found.size(),
                       shown.looked_for);
}

}  // namespace gripscan::ui
