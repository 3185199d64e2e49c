#include "ui/views/cell_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/robot/joint6_limits.h"

namespace gripscan::ui {
namespace {

constexpr double kPercent = 100.0;

std::array<double, kPlanFields> numbers_of(const TurnPlan& plan) {
    return {deg_from_rad(plan.limits.angle_rad),
            plan.limits.sigmas,
            plan.limits.overlap * kPercent,
            plan.limits.slip_m * kMmPerM,
            deg_from_rad(plan.limits.tilt_rad),
            deg_from_rad(plan.step_rad),
            plan.speed_percent};
}

/// Away from what converting back and forth adds.
double plain(double number) {
    return std::round(number * 1e9) / 1e9;
}

std::string_view word_of(const CheckSummary& summary) {
    return word(summary.outcome);
}

/// Whether the value of a row has to stay below its limit; by the table in cell_limits.h.
std::optional<bool> is_at_most(const CellCheckItem& item) {
    struct Row {
        std::string_view name;
        std::string_view unit;
        bool at_most;
    };
    static constexpr std::array<Row, 20> kRows{
        {{"link", "ms", true},   {"link", "answers", false}, {"controller", "", true},
         {"joints", "", false},  {"range", "", false},       {"cable", "", true},
         {"return", "", false},  {"volume", "", false},      {"depth", "", true},
         {"exposure", "", true}, {"brightness", "", false},  {"texture", "", false},
         {"fill", "", false},    {"surface", "", false},     {"alone", "", true},
         {"joint", "mm", false}, {"joint", "mm²", true},     {"sweep", "", false},
         {"disk", "", false},    {"duration", "", true}}};
    for (const Row& row : kRows) {
        if (row.name == item.name && (row.unit.empty() || row.unit == item.unit)) {
            return row.at_most;
        }
    }
    return std::nullopt;
}

}  // namespace

std::array<PlanField, kPlanFields> plan_fields(const TurnPlan& plan) {
    std::array<PlanField, kPlanFields> fields{
        {{"plan.angle", "Angle error", "deg", 2, 0.01, 5.0},
         {"plan.sigmas", "Error over sigma", "σ", 1, 1.0, 10.0},
         {"plan.overlap", "Overlap at least", "%", 0, 5.0, 95.0},
         {"plan.slip", "Shift along the axis", "mm", 2, 0.05, 10.0},
         {"plan.tilt", "Tilt of the axis", "deg", 2, 0.05, 20.0},
         {"plan.step", "Step", "deg", 1, 1.0, 90.0},
         {"plan.speed", "Speed", "%", 0, kLeastSpeed_percent, kMostSpeed_percent}}};
    const auto values = numbers_of(plan);
    const auto standards = numbers_of(TurnPlan{});
    for (std::size_t i = 0; i < kPlanFields; ++i) {
        fields[i].value = plain(values[i]);
        fields[i].standard = plain(standards[i]);
    }
    return fields;
}

TurnPlan with_plan_field(TurnPlan plan, std::size_t field, double value) {
    switch (field) {
        case 0:
            plan.limits.angle_rad = rad_from_deg(value);
            break;
        case 1:
            plan.limits.sigmas = value;
            break;
        case 2:
            plan.limits.overlap = value / kPercent;
            break;
        case 3:
            plan.limits.slip_m = value / kMmPerM;
            break;
        case 4:
            plan.limits.tilt_rad = rad_from_deg(value);
            break;
        case 5:
            plan.step_rad = rad_from_deg(value);
            break;
        case kSpeedField:
            plan.speed_percent = value;
            break;
        default:
            break;
    }
    return plan;
}

std::string why_speed_is_fixed(const Snapshot& snapshot) {
    if (snapshot.procedure == nullptr) return "No session is open.";
    if (snapshot.session && snapshot.session->recorded) {
        return "A recording is only looked at: it keeps the limits it was judged by.";
    }
    if (std::holds_alternative<phase::Busy>(snapshot.procedure->phase) ||
        snapshot.procedure->running) {
        return "Something is going on.";
    }
    return {};
}

std::string why_plan_is_fixed(const Snapshot& snapshot) {
    if (snapshot.procedure != nullptr && !(snapshot.session && snapshot.session->recorded) &&
        !snapshot.procedure->data.captures.empty()) {
        return "The first view is taken: every step of a turn is judged by the same limits.";
    }
    return why_speed_is_fixed(snapshot);
}

std::string why_region_is_fixed(const Snapshot& snapshot) {
    if (!snapshot.session || snapshot.procedure == nullptr) return "No session is open.";
    if (snapshot.session->recorded) return "A recording keeps the area it was taken in.";
    if (snapshot.cell.file.empty()) {
        return "The simulated cell brings its own area; that of a cell file can be edited.";
    }
    if (!snapshot.procedure->data.captures.empty()) {
        return "The first view is taken: every view of a turn shows the same area.";
    }
    if (!snapshot.cell.region) return "The cell file names no area to begin with.";
    return why_speed_is_fixed(snapshot);
}

std::optional<Box> edited_region(const CellFrame& cell) {
    return cell.wished_region ? cell.wished_region : cell.region;
}

Box with_region_end(Box region, int axis, bool upper, double value_m) {
    constexpr double kThinnest_m = 0.01;
    if (upper) {
        region.max_m[axis] = value_m;
        region.min_m[axis] = std::min(region.min_m[axis], value_m - kThinnest_m);
    } else {
        region.min_m[axis] = value_m;
        region.max_m[axis] = std::max(region.max_m[axis], value_m + kThinnest_m);
    }
    return region;
}

std::span<const std::size_t> limit_fields(std::string_view evidence) {
    static constexpr std::array<std::size_t, 2> kAngle{0, 1};
    static constexpr std::array<std::size_t, 1> kOverlap{2};
    static constexpr std::array<std::size_t, 1> kSlip{3};
    static constexpr std::array<std::size_t, 1> kTilt{4};
    if (evidence == "evidence.angle_error") return kAngle;
    if (evidence == "evidence.overlap") return kOverlap;
    if (evidence == "evidence.slip") return kSlip;
    if (evidence == "evidence.axis_tilt") return kTilt;
    return {};
}

std::string why_limit_is_fixed(const Snapshot& snapshot, std::string_view evidence) {
    if (limit_fields(evidence).empty()) return "The plan does not set it.";
    return why_plan_is_fixed(snapshot);
}

LinkText link_text(const ProcedureState* state) {
    if (state == nullptr) return {false, "no session", {}};
    if (const auto* off = std::get_if<phase::Offline>(&state->phase)) {
        return {false, "not connected", off->why};
    }
    if (std::holds_alternative<phase::Connecting>(state->phase)) return {false, "connecting", {}};
    return {true, "connected", {}};
}

std::string controller_text(const ControllerState& c) {
    std::string text = c.automatic ? "AUTO" : "not in AUTO";
    if (c.emergency_stop) text += ", emergency stop";
    if (c.fault) text += ", fault";
    text += c.servo_on ? ", servo on" : ", servo off";
    text += fmt::format(", override {} %", c.override_percent);
    if (!c.alarm.empty()) text += ", " + c.alarm;
    return text;
}

std::array<double, 6> tool_numbers(const Pose& T) {
    const EulerAngles wpr = euler_from_rotation(T.linear());
    const Eigen::Vector3d mm = T.translation() * kMmPerM;
    return {mm.x(),
            mm.y(),
            mm.z(),
            deg_from_rad(wpr.roll_rad),
            deg_from_rad(wpr.pitch_rad),
            deg_from_rad(wpr.yaw_rad)};
}

CheckSummary check_summary(const ProcedureState* state) {
    CheckSummary summary;
    if (state == nullptr || !state->cell) {
        summary.words = "not checked yet";
        return summary;
    }
    std::array<int, 4> counts{};
    std::string failed;
    for (const CellCheckItem& item : state->cell->items) {
        ++counts[static_cast<std::size_t>(item.outcome)];
        if (item.outcome == CheckOutcome::kFailed)
            failed += (failed.empty() ? "" : ", ") + item.name;
    }
    const int passed = counts[static_cast<std::size_t>(CheckOutcome::kPassed)];
    const int warned = counts[static_cast<std::size_t>(CheckOutcome::kWarned)];
    const int skipped = counts[static_cast<std::size_t>(CheckOutcome::kSkipped)];
    if (!failed.empty()) {
        summary.outcome = CheckOutcome::kFailed;
        summary.can_be_accepted = state->cell_note.empty();
        summary.words = fmt::format("{}: {}", word_of(summary), failed);
        if (!state->cell_note.empty()) summary.words += " – accepted: " + state->cell_note;
        return summary;
    }
    summary.outcome = warned > 0 ? CheckOutcome::kWarned : CheckOutcome::kPassed;
    summary.words = fmt::format("{} passed", passed);
    if (warned > 0) summary.words += fmt::format(", {} warned", warned);
    if (skipped > 0) summary.words += fmt::format(", {} not measured yet", skipped);
    return summary;
}

std::string check_number(const CellCheckItem& item, double number) {
    if (item.outcome == CheckOutcome::kSkipped || !std::isfinite(number)) return "–";
    const int decimals = number == std::round(number) ? 0 : std::abs(number) >= 100 ? 0 : 2;
    std::string text = fmt::format("{:.{}f}", std::abs(number), decimals);
    return (number < 0 ? "−" : "") + text;
}

std::string limit_text(const CellCheckItem& item) {
    const std::string limit = check_number(item, item.limit);
    const auto at_most = is_at_most(item);
    if (!at_most || limit == "–") return limit;
    return (*at_most ? "≤ " : "≥ ") + limit;
}

}  // namespace gripscan::ui
