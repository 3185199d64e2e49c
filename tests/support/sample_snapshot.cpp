#include "tests/support/sample_snapshot.h"

#include <array>
#include <cmath>
#include <ctime>

#include "core/base/units.h"
#include "core/geometry/axis.h"

namespace gripscan::test {
namespace {

using namespace gripscan::ui;

/// Of one step, in the units of Table 1.
struct Numbers {
    double robot_deg;
    double icp_deg;
    double sigma_deg;
    double tilt_deg;
    double offset_mm;
    double slip_mm;
    double overlap;
    double rms_mm;
    double p90_mm;
    double observability;
};

constexpr std::array<Numbers, 14> kSteps{{
    {9.998, 10.008, 0.030, 0.047, 0.09, 0.01, 0.86, 0.22, 0.36, 0.51},
    {10.004, 10.035, 0.033, 0.039, 0.06, -0.03, 0.83, 0.20, 0.35, 0.57},
    {9.996, 9.979, 0.031, 0.037, 0.09, 0.00, 0.82, 0.21, 0.34, 0.53},
    {10.004, 10.013, 0.030, 0.067, 0.07, -0.01, 0.83, 0.21, 0.37, 0.53},
    {10.001, 10.013, 0.030, 0.031, 0.09, -0.06, 0.87, 0.23, 0.37, 0.60},
    {9.997, 9.941, 0.029, 0.052, 0.05, 0.07, 0.85, 0.22, 0.36, 0.49},
    {10.003, 10.021, 0.028, 0.044, 0.08, 0.03, 0.84, 0.21, 0.35, 0.52},
    {10.001, 10.053, 0.028, 0.058, 0.07, 0.02, 0.82, 0.21, 0.35, 0.49},
    {9.998, 10.026, 0.031, 0.064, 0.11, -0.04, 0.84, 0.23, 0.35, 0.46},
    {9.999, 9.994, 0.027, 0.035, 0.08, -0.05, 0.85, 0.21, 0.37, 0.58},
    {10.002, 10.111, 0.036, 0.022, 0.04, -0.15, 0.80, 0.24, 0.33, 0.46},
    {9.998, 9.985, 0.030, 0.032, 0.10, 0.05, 0.81, 0.20, 0.33, 0.44},
    {10.002, 9.959, 0.029, 0.041, 0.04, 0.06, 0.83, 0.23, 0.37, 0.55},
    {9.998, 9.977, 0.030, 0.056, 0.09, 0.09, 0.88, 0.21, 0.38, 0.62},
}};
constexpr Numbers kRefused{10.001, 24.299, 0.030, 1.291, 4.86, -0.94, 0.41, 0.31, 0.55, 0.41};

constexpr double kStep_rad = 10.0 * kRadPerDeg;
constexpr double kStart_rad = -180.0 * kRadPerDeg;

RobotReading reading_at(double turned_rad) {
    RobotReading reading;
    for (std::size_t i = 0; i < 5; ++i) {
        reading.joints_rad[i] = rad_from_deg(std::array{0.0, 12.0, -8.0, 0.0, -52.0}[i]);
    }
    reading.joints_rad[5] = kStart_rad + turned_rad;
    return reading;
}

Axis axis_of_cell() {
    return {{0.01, 0.004, 0.72}, Eigen::Vector3d(0.97, -0.1, 0.2).normalized()};
}

CaptureRecord capture(int index, double turned_rad) {
    CaptureRecord record;
    record.index = index;
    record.commanded_rad = kStep_rad * index;
    record.before = reading_at(turned_rad);
    record.joint6_after_rad = record.before->joints_rad[5];
    record.t_s = 8.0 * index;
    return record;
}

JudgedStep judged(int from, const Numbers& n) {
    JudgedStep step;
    TurnStep& row = step.row;
    row.index = from + 1;
    row.from = from;
    row.to = from + 1;
    row.commanded_rad = kStep_rad;
    row.robot_rad = rad_from_deg(n.robot_deg);
    row.icp_rad = rad_from_deg(n.icp_deg);
    row.error_rad = *row.icp_rad - *row.robot_rad;
    row.sigma_rad = rad_from_deg(n.sigma_deg);
    row.tilt_rad = rad_from_deg(n.tilt_deg);
    row.axis_offset_m = n.offset_mm / kMmPerM;
    row.slip_m = n.slip_mm / kMmPerM;
    row.overlap = n.overlap;
    row.rms_m = n.rms_mm / kMmPerM;
    row.median_m = 0.6 * n.rms_mm / kMmPerM;
    row.p90_m = n.p90_mm / kMmPerM;
    row.observability = n.observability;
    row.T = turn_about(axis_of_cell(), *row.icp_rad);
    row.verdict = Verdict::kAccept;
    row.sentence = fmt::format("agrees with the robot: error {:+.3f} deg", n.icp_deg - n.robot_deg);
    return step;
}

void add_capture(ProcedureState& state) {
    double turned_rad = 0.0;
    for (const auto& [pair, step] : state.judged) turned_rad += *step.row.robot_rad;
    const int index = state.data.next_index();
    state.data.captures.push_back(capture(index, turned_rad));
    state.reading = reading_at(turned_rad);
}

void add_step(ProcedureState& state, JudgedStep step) {
    state.judged[{step.row.from, step.row.to}] = std::move(step);
    add_capture(state);
}

/// What is beyond the angle's limit, but not twice: to be checked.
JudgedStep close_to_the_limit(JudgedStep step) {
    step.row.verdict = Verdict::kCheck;
    step.row.cause = Cause::kDepthDistortion;
    step.row.sentence =
        "scans turned by 10.111 deg, robot by 10.002 deg: error +0.109 deg, limit 0.108 deg";
    return step;
}

CellCheckItem item(const char* name, CheckOutcome outcome, double value, double limit,
                   const char* unit, const char* sentence) {
    return {name, outcome, value, limit, unit, sentence};
}

CellReport report_of_cell() {
    using enum CheckOutcome;
    return {
        {item("link", kPassed, 3.1, 500, "ms", "20 round trips: median 1.2 ms, longest 3.1 ms"),
         item("controller", kPassed, 0, 0, "conditions",
              "AUTO, servo on, no fault; override 100 %"),
         item("joints", kPassed, 88.0, 0, "deg",
              "joint 5 is the nearest to the end of its range: 88.0 deg"),
         item("range", kPassed, 360.0, 0, "deg",
              "joint 6 turns from -180.0 to 180.0 deg, its range is -360 … 360 deg"),
         item("volume", kWarned, 9.0, 0, "px",
              "of the region's corners the far right one is nearest a border: 9 px; move the "
              "camera back or towards it, or make the region smaller"),
         item("depth", kPassed, 0.42, 2, "mm",
              "the far side at 0.80 m has a disparity of 148 px: depth is good to 0.42 mm there"),
         item("exposure", kPassed, 0.2, 2, "%", "0.20 % of the region's image is black or white"),
         item("texture", kPassed, 9.1, 3.5, "levels", "median contrast 9.1 levels"),
         item("fill", kPassed, 93, 10, "%",
              "93 % of the textured pixels have a depth inside the region"),
         item("disk", kPassed, 52000, 900, "MB", "52000 MB free, the session may take 900 MB"),
         item("duration", kPassed, 8.0, 60, "min",
              "37 captures in about 8.0 min: each 4.1 s motion, 1.0 s settling, 0.2 s exposure, "
              "7.5 s computing")}};
}

void add_log(Sample& sample, int second, LogLevel level, const char* code, const char* text) {
    std::tm local{};
    local.tm_year = 126;
    local.tm_mon = 4;
    local.tm_mday = 12;
    local.tm_hour = 14;
    local.tm_min = 31;
    local.tm_sec = second;
    local.tm_isdst = -1;
    sample.log->push_back(
        {std::chrono::system_clock::from_time_t(std::mktime(&local)), level, code, text});
    sample.snapshot.log = *sample.log;
}

/// Grey speckles with a darker block that moves with the turn.
cv::Mat image_of(int index, int shift_px) {
    cv::Mat image(240, 320, CV_8UC1);
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            const int block_x = x + shift_px - 110 - 2 * index;
            const bool block = block_x > 0 && block_x < 100 && y > 70 && y < 180;
            const unsigned noise = static_cast<unsigned>((x + shift_px) * 2654435761U) ^
                                   static_cast<unsigned>(y * 40503U);
            image.at<std::uint8_t>(y, x) =
                static_cast<std::uint8_t>((block ? 70U : 150U) + (noise >> 9U) % 60U);
        }
    }
    return image;
}

void show_captures(Sample& sample) {
    const auto& captures = sample.state->data.captures;
    sample.snapshot.captures.clear();
    for (const CaptureRecord& record : captures) {
        auto picture = std::make_shared<StereoPicture>();
        if (record.index + 2 >= static_cast<int>(captures.size())) {
            picture->left = image_of(record.index, 0);
            picture->right = image_of(record.index, 24);
        }
        picture->left_health = StereoHealth{};
        picture->t_s = record.t_s;
        ShownCapture shown;
        shown.index = record.index;
        shown.attempt = record.attempt;
        shown.picture = std::move(picture);
        sample.snapshot.captures.push_back(std::move(shown));
    }
}

void select_last(Sample& sample) {
    const auto rows = table_of(*sample.state).size();
    sample.snapshot.selected_row = rows == 0 ? 0 : rows - 1;
    sample.snapshot.follows_last = true;
}

Sample with_steps(std::size_t count) {
    Sample sample = sample_cell_checked();
    ProcedureState& state = *sample.state;
    event::AxisFound found;
    found.axis = AxisEstimate{axis_of_cell(), rad_from_deg(0.04), 0.00011};
    found.sentence = "axis found in 3 views: direction to 0.04 deg, place to 0.11 mm";
    state.warm_up = found;
    state.warm_up_shots = 3;
    add_capture(state);
    for (std::size_t i = 0; i < count; ++i) {
        JudgedStep step = judged(static_cast<int>(i), kSteps[i % kSteps.size()]);
        if (i % kSteps.size() == 10) step = close_to_the_limit(std::move(step));
        add_step(state, std::move(step));
    }
    sample.snapshot.cell.axis = found.axis->axis;
    sample.snapshot.cell.axis_sd_rad = found.axis->sd_rad;
    sample.snapshot.cell.axis_sd_m = found.axis->sd_m;
    return sample;
}

}  // namespace

Sample sample_empty() {
    Sample sample{std::make_shared<ProcedureState>(), std::make_shared<std::vector<LogLine>>(), {}};
    ProcedureState& state = *sample.state;
    state.data.step_rad = kStep_rad;
    state.plan.limits = {rad_from_deg(0.1), 3.0, 0.6, 0.3e-3, rad_from_deg(0.2)};
    Snapshot& snapshot = sample.snapshot;
    snapshot.page = Page::kProcedure;
    snapshot.session = SessionFacts{"/data/valve-T20", "valve-T20", "simulated cell", false, {}};
    snapshot.procedure = sample.state.get();
    snapshot.cell.region = Box{{-0.1, -0.09, 0.62}, {0.12, 0.09, 0.82}};
    snapshot.version = "0.1.0";
    add_log(sample, 2, LogLevel::kInformation, "SES-001",
            "Session valve-T20 made, 36 steps of 10°");
    return sample;
}

Sample sample_cell_checked() {
    Sample sample = sample_empty();
    ProcedureState& state = *sample.state;
    state.phase = phase::Idle{};
    state.robot = RobotIdentity{"CRX-10iA", 6, "GSP/1.0"};
    state.reading = reading_at(0.0);
    state.cell = report_of_cell();
    add_log(sample, 9, LogLevel::kInformation, "ROB-001", "CRX-10iA linked, GSP/1.0");
    add_log(sample, 15, LogLevel::kWarning, "CEL-005", "Volume: 9 px to the image border");
    select_last(sample);
    return sample;
}

Sample sample_running() {
    Sample sample = with_steps(14);
    add_log(sample, 52, LogLevel::kInformation, "CAP-001",
            "Capture 14: fill 93 %, J6 −40.000°, still");
    add_log(sample, 53, LogLevel::kInformation, "REG-001", "Aligned in 0.84 s, overlap 88 %");
    add_log(sample, 53, LogLevel::kInformation, "REG-010", "Step 14 accepted, error −0.021°");
    sample.snapshot.seconds_left = 312.0;
    show_captures(sample);
    select_last(sample);
    return sample;
}

Sample sample_rejected() {
    Sample sample = with_steps(5);
    JudgedStep step = judged(5, kRefused);
    step.row.verdict = Verdict::kReject;
    step.row.cause = Cause::kOverlap;
    step.row.sentence = "overlap 41 %, limit 60 %: the step is too large";
    add_step(*sample.state, step);
    Advice advice;
    advice.action = AdvisedAction::kHalve;
    advice.cause = Cause::kOverlap;
    advice.sentence = "the step is too large for this side: go back by half of it";
    advice.evidence = {"overlap 41 %, least 60 %", "axis tilted by 1.29 deg, limit 0.20 deg"};
    sample.state->phase = phase::Deciding{advice};
    sample.state->advice.push_back({5, 6, advice});
    add_log(sample, 7, LogLevel::kInformation, "CAP-001",
            "Capture 6: fill 91 %, J6 −120.000°, still");
    add_log(sample, 7, LogLevel::kWarning, "CAM-021", "Right image: fill 78 %, elsewhere 93 %");
    add_log(sample, 9, LogLevel::kError, "REG-012", "Step 6: ICP 24.299° against 10.001°");
    add_log(sample, 9, LogLevel::kWarning, "ADV-002", "Step too large: halve to 5°, or retry");
    show_captures(sample);
    select_last(sample);
    return sample;
}

Sample sample_finished() {
    Sample sample = with_steps(36);
    ProcedureState& state = *sample.state;
    state.phase = phase::Finished{};
    state.solved = event::Solved{34, 36, 369090};
    auto solved = std::make_shared<ComputedTurn>();
    TurnReport& report = solved->report;
    report.limits = state.plan.limits;
    for (const JudgedStep& step : table_of(state)) report.steps.push_back(step.row);
    report.axis = state.warm_up->axis;
    report.closure_before = Closure{rad_from_deg(0.21), 0.00042};
    report.closure_after = Closure{rad_from_deg(0.03), 0.00008};
    sample.snapshot.solved = solved;
    sample.snapshot.last_export = "valve-T20.pcd, 369 090 points, read back equal";
    add_log(sample, 58, LogLevel::kInformation, "REG-040", "Turn solved: closure 0.21°, 0.42 mm");
    show_captures(sample);
    select_last(sample);
    return sample;
}

Sample sample_link_lost() {
    Sample sample = with_steps(8);
    activity::Moving moving;
    moving.command = {21, kStart_rad + 9 * kStep_rad, 10.0};
    moving.shot = Shot{ShotPurpose::kTurn, 9, 1, 9 * kStep_rad};
    const std::string why = "192.168.1.10:16001: no answer to 3 heartbeats";
    sample.state->phase = phase::Interrupted{moving, why};
    add_log(sample, 41, LogLevel::kError, "ROB-007", "Link lost: no answer to 3 heartbeats");
    sample.snapshot.error =
        ShownError{"The link to the robot was lost", why,
                   "Look whether the arm stands. Check the cable, then connect again and resume.",
                   "",
                   {}};
    show_captures(sample);
    select_last(sample);
    return sample;
}

Sample sample_aligning() {
    Sample sample = sample_running();
    add_capture(*sample.state);
    sample.state->running = true;
    sample.state->phase = phase::Busy{activity::Judging{14, 15}};
    sample.snapshot.job = ShownJob{"Aligning step 15", 0.62, 0.6, true};
    show_captures(sample);
    return sample;
}

void set_mode(Sample& sample, MotionMode mode) {
    sample.state->plan.mode = mode;
    sample.snapshot.session->cell_name =
        mode == MotionMode::kSim ? "simulated cell" : "cell-3.yaml";
}

}  // namespace gripscan::test
