#include "tests/support/sample_pages.h"

#include <cmath>
#include <numbers>

#include "core/base/seeded_random.h"
#include "core/base/units.h"

namespace gripscan::test {
namespace {

using End = ui::RecentSession::End;

/// 23 November 2026, 14:32 UTC, less some minutes.
std::chrono::system_clock::time_point minutes_before(int minutes) {
    return std::chrono::system_clock::time_point(std::chrono::seconds(1795444320)) -
           std::chrono::minutes(minutes);
}

CellCheckItem item(std::string name, CheckOutcome outcome, double value, double limit,
                   std::string unit, std::string sentence) {
    return {std::move(name), outcome, value, limit, std::move(unit), std::move(sentence)};
}

CellReport report_of(bool failed) {
    using enum CheckOutcome;
    CellReport report;
    report.items = {
        item("link", kPassed, 3.1, 500, "ms", "The longest of 20 round trips took 3.1 ms."),
        item("controller", kPassed, 0, 0, "", "Nothing forbids a motion."),
        item("joints", kPassed, 21.4, 0, "deg", "J5 is nearest the end of its range."),
        item("range", kPassed, 180, 0, "deg", "The turn leaves 180 deg of joint 6."),
        item("cable", kPassed, 360, 370, "deg", "Joint 6 goes 360 deg from where it stands."),
        item("volume", kPassed, 41, 0, "px", "All corners lie inside both images."),
        item("depth", kPassed, 0.31, 2, "mm", "Standard deviation of depth at the far side."),
        failed ? item("exposure", kFailed, 6.4, 2, "%",
                      "6.4 % of the region is saturated: shorten the exposure or dim the light.")
               : item("exposure", kPassed, 0.2, 2, "%", "0.2 % of the region is saturated."),
        item("brightness", kPassed, 96, 25, "", "The mean level is 96 of 255."),
        item("texture", kPassed, 11.2, 3.5, "", "The surface has contrast to be matched by."),
        failed ? item("fill", kWarned, 11, 10, "%", "Few pixels have a depth; look at the light.")
               : item("fill", kPassed, 62, 10, "%", "62 % of the textured pixels have a depth."),
        item("alone", kPassed, 0, 120, "mm²", "Nothing stands apart from the gripper."),
        item("joint", kSkipped, 0, 40, "mm", "Not measured: nothing was turned."),
        item("disk", kPassed, 18400, 210, "MB", "Room for the turn 87 times over."),
        item("duration", kPassed, 6, 60, "min", "A turn of 36 steps takes about 6 min.")};
    return report;
}

}  // namespace

std::vector<ui::RecentSession> sample_recent() {
    const auto line = [](std::string name, std::string kind, std::string cell, int done, int total,
                         std::optional<double> deg, std::optional<double> mm, End end,
                         std::string sentence, int minutes) {
        return ui::RecentSession{"/sessions/" + name,
                                 name,
                                 std::move(kind),
                                 std::move(cell),
                                 done,
                                 total,
                                 deg,
                                 mm,
                                 end,
                                 std::move(sentence),
                                 minutes_before(minutes)};
    };
    return {
        line("valve-T20", "object", "SIM", 14, 36, {}, {}, End::kInterrupted,
             "step 15 is next, nothing is lost", 0),
        line("valve-T18", "object", "SIM", 36, 36, 0.07, 0.24, End::kComplete, "complete", 72),
        line("gripper G2", "gripper", "SIM", 36, 36, 0.06, 0.21, End::kComplete, "complete", 164),
        line("bracket-A4", "object", "cell-3", 36, 36, 0.31, 0.88, End::kCheck,
             "step 11 to be checked", 1287),
        line("hose-clamp", "object", "cell-3", 11, 36, {}, {}, End::kRejected,
             "step 11 rejected: symmetry", 1380),
        line("gripper G1", "gripper", "cell-3", 72, 72, 0.04, 0.17, End::kComplete, "complete",
             1701),
        line("elbow-90", "object", "cell-3", 22, 36, {}, {}, End::kInterrupted,
             "step 23 is next, nothing is lost", 2752),
        line("hall check", "environment", "cell-3", 0, 0, {}, {}, End::kMissing,
             "the folder is gone", 3270)};
}

ui::ShownTemplate sample_template(const TemplateFilter& filter) {
    auto cloud = std::make_shared<Cloud>();
    SeededRandom random(7);
    for (int i = 0; i < 6000; ++i) {
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double radius = 0.040 + (i % 97 == 0 ? 0.02 * random.uniform() : 0.0);
        cloud->points.emplace_back(static_cast<float>(radius * std::cos(angle)),
                                   static_cast<float>(random.uniform(-0.06, 0.06)),
                                   static_cast<float>(0.6 + radius * std::sin(angle)));
        cloud->normals.emplace_back(static_cast<float>(std::cos(angle)), 0.0F,
                                    static_cast<float>(std::sin(angle)));
        cloud->seen.push_back(
            static_cast<std::uint16_t>(std::clamp(13.0 + 4.5 * random.normal(), 1.0, 24.0)));
        cloud->sigma.push_back(1.1e-4F);
    }
    const auto filtered = filter_template(*cloud, filter, for_each_in_order);
    ui::ShownTemplate shown;
    shown.kept = std::make_shared<Cloud>(select(*cloud, filtered.kept));
    shown.whole_facts = template_facts(*cloud, for_each_in_order);
    shown.kept_facts = template_facts(*shown.kept, for_each_in_order);
    shown.whole = std::move(cloud);
    shown.counts = filtered.counts;
    shown.filter = filter;
    return shown;
}

ProcedureState sample_cell_state(SampleCell outcome) {
    ProcedureState state;
    state.phase = phase::Idle{};
    state.data.step_rad = state.plan.step_rad;
    state.robot = RobotIdentity{"LR Mate 200iC/5L", 6, "GSP/1.0"};
    RobotReading reading;
    const std::array<double, 6> joints_deg{12.5, -20.0, 35.25, 0.0, -62.0, -90.0};
    for (std::size_t i = 0; i < 6; ++i) reading.joints_rad[i] = rad_from_deg(joints_deg[i]);
    reading.T_world_tool.translation() = Eigen::Vector3d(0.4312, -0.0127, 0.3891);
    reading.T_world_tool.linear() = rotation_from_euler({3.1, -0.02, 1.57});
    state.reading = reading;
    if (outcome != SampleCell::kNotChecked) {
        state.cell = report_of(outcome == SampleCell::kFailed);
    }
    return state;
}

ui::CellFrame sample_cell_frame() {
    ui::CellFrame frame;
    RectifiedRig rig;
    rig.image = {1280, 960};
    rig.f_px = 1612.4;
    rig.baseline_m = 0.1201;
    rig.cx_left_px = rig.cx_right_px = 640;
    rig.cy_px = 480;
    frame.rig = rig;
    frame.region = Box{{-0.06, -0.08, 0.5}, {0.08, 0.08, 0.7}};
    return frame;
}

std::vector<ui::KeyBinding> sample_keys() {
    return {{"step.step", "Step and capture", "Space", "Procedure", "Space"},
            {"step.capture", "Capture", "C", "Procedure", "C"},
            {"step.retry", "Retry", "R", "Procedure", "R"},
            {"step.halve", "Halve", "H", "Procedure", "H"},
            {"step.accept", "Accept", "A", "Procedure", "A"},
            {"step.back", "Back", "B", "Procedure", "B"},
            {"step.stop", "Stop", "Esc", "Procedure", "Esc"},
            {"edit.undo", "Undo", "Ctrl Z", "Edit", "Ctrl Z"},
            {"edit.redo", "Redo", "Ctrl Y", "Edit", "Ctrl Y"},
            {"view.fit", "Fit", "F", "View", "F"},
            {"view.larger", "Larger", "Ctrl +", "View", "Ctrl +"},
            {"view.smaller", "Smaller", "Ctrl −", "View", "Ctrl −"},
            {"window.keys", "All keys", "F1", "Window", "F1"}};
}

ui::Snapshot sample_template_page() {
    ui::Snapshot snapshot;
    snapshot.page = ui::Page::kTemplate;
    ui::SessionFacts facts;
    facts.folder = "/sessions/valve-T20";
    facts.name = "valve-T20";
    snapshot.session = facts;
    snapshot.filter.crop = Box{{-0.05, -0.05, 0.55}, {0.05, 0.05, 0.65}};
    snapshot.filter.min_seen = 8;
    snapshot.filter.denoise_sigmas = 1.5;
    snapshot.shown_template = sample_template(snapshot.filter);
    auto solved = std::make_shared<ComputedTurn>();
    for (int i = 1; i <= 36; ++i) {
        TurnStep step;
        step.index = i;
        step.verdict = i == 11 ? Verdict::kCheck : Verdict::kAccept;
        solved->report.steps.push_back(step);
    }
    solved->report.closure_before = solved->report.closure_after =
        Closure{rad_from_deg(0.07), 0.24e-3};
    solved->report.axis = AxisEstimate{};
    snapshot.solved = solved;
    return snapshot;
}

ui::Snapshot sample_recognised() {
    ui::Snapshot snapshot;
    snapshot.page = ui::Page::kRecognise;
    snapshot.session =
        ui::SessionFacts{"/data/valve-T20", "valve-T20", "simulated cell", false, {}};
    static const ProcedureState kState = sample_cell_state(SampleCell::kPassed);
    snapshot.procedure = &kState;
    snapshot.cell = sample_cell_frame();
    snapshot.library = {
        {"gripper-G2", ui::TemplateKind::kGripper, 41180, "none", "", ""},
        {"valve-T18", ui::TemplateKind::kObject, 18210, "none", "held by gripper-G2",
         "valve-T18 was registered with another template of gripper-G2"},
        {"valve-T20", ui::TemplateKind::kObject, 21604, "2-fold", "held by gripper-G2", ""}};
    auto shown = std::make_shared<ui::ShownRecognition>();
    shown->view = 3;
    shown->seconds = 0.42;
    shown->looked_for = 3;
    shown->least_score = 0.45;
    shown->least_found = 0.25;
    const auto found = [&](const char* name, ui::TemplateKind kind, double x_m) {
        ui::FoundTemplate f;
        f.name = name;
        f.kind = kind;
        f.T_camera_template.linear() = rotation_from_euler({0.4, -0.2, 0.1});
        f.T_camera_template.translation() = Eigen::Vector3d(x_m, 0.01, 0.74);
        f.T_robot_template = turn_about(Axis{}, 1.2) * f.T_camera_template;
        f.T_gripper_template = turn_about(Axis{}, 0.2);
        f.score = 0.91;
        f.support = 0.97;
        f.found = 0.87;
        f.outline = 0.82;
        f.rms_m = 0.27e-3;
        f.tolerance_m = 1.0e-3;
        f.box = {{-0.03, -0.04, -0.03}, {0.03, 0.04, 0.03}};
        shown->found.push_back(f);
    };
    found("gripper-G2", ui::TemplateKind::kGripper, 0.09);
    found("valve-T20", ui::TemplateKind::kObject, 0.0);
    shown->found[1].symmetry = "2-fold";
    shown->joint6_robot_rad = rad_from_deg(60.004);
    shown->joint6_gripper_rad = rad_from_deg(60.020);
    shown->grasp = ui::ShownGrasp{"valve-T20", turn_about(Axis{}, 0.7), true,
                                  "The arm reaches it with J1 12.5°, J5 −62.0°."};
    auto picture = std::make_shared<ui::StereoPicture>();
    picture->left = cv::Mat(960, 1280, CV_8U);
    for (int y = 0; y < 960; ++y) {
        for (int x = 0; x < 1280; ++x) {
            picture->left.at<std::uint8_t>(y, x) =
                static_cast<std::uint8_t>(90 + (x * 7 + y * 13) % 40);
        }
    }
    picture->right = picture->left;
    shown->picture = std::move(picture);
    snapshot.recognition = std::move(shown);
    return snapshot;
}

}  // namespace gripscan::test
