// What the cell page says, without drawing.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// A number of the plan as it is edited, in the unit of the screen.
struct PlanField {
    std::string_view id;  ///< "plan.angle"
    std::string_view label;
    std::string_view unit;
    int decimals = 0;
    double min = 0.0;
    double max = 0.0;
    double value = 0.0;
    double standard = 0.0;

    [[nodiscard]] bool changed() const { return value != standard; }
};

inline constexpr std::size_t kPlanFields = 7;
/// Limits of a step, then its size and speed.
[[nodiscard]] std::array<PlanField, kPlanFields> plan_fields(const TurnPlan& plan);
/// The plan with one of them set.
[[nodiscard]] TurnPlan with_plan_field(TurnPlan plan, std::size_t field, double value);
/// Why they cannot be changed any more; empty: they can.
[[nodiscard]] std::string why_plan_is_fixed(const Snapshot& snapshot);
/// The speed of joint 6 may change between the steps of a turn.
[[nodiscard]] std::string why_speed_is_fixed(const Snapshot& snapshot);
/// Its place among the fields of the plan.
constexpr std::size_t kSpeedField = 6;
/// The fields that make the limit of a line of evidence ("evidence.slip"); empty: no plan sets it.
[[nodiscard]] std::span<const std::size_t> limit_fields(std::string_view evidence);
/// Why that limit cannot be changed now; empty: it can.
[[nodiscard]] std::string why_limit_is_fixed(const Snapshot& snapshot, std::string_view evidence);

/// Why the registration area of the next session cannot be edited; empty: it can.
[[nodiscard]] std::string why_region_is_fixed(const Snapshot& snapshot);
/// The area as it is edited: as wished, else as it is.
[[nodiscard]] std::optional<Box> edited_region(const CellFrame& cell);
/// That area with one of its ends moved, m; ends never meet: the other one gives way.
[[nodiscard]] Box with_region_end(Box region, int axis, bool upper, double value_m);

/// "connected", "not connected", with the reason where there is one.
struct LinkText {
    bool up = false;
    std::string word;
    std::string why;
};
[[nodiscard]] LinkText link_text(const ProcedureState* state);
/// "AUTO, servo on, override 100 %".
[[nodiscard]] std::string controller_text(const ControllerState& controller);

/// X Y Z in mm, W P R in deg.
[[nodiscard]] std::array<double, 6> tool_numbers(const Pose& T_world_tool);

/// How the check stands: "15 of 15 passed", "2 failed: exposure, fill".
struct CheckSummary {
    CheckOutcome outcome = CheckOutcome::kSkipped;
    std::string words;
    bool can_be_accepted = false;  ///< it failed, and nobody has accepted it
};
[[nodiscard]] CheckSummary check_summary(const ProcedureState* state);

/// A value or limit of the check: whole where it is large.
[[nodiscard]] std::string check_number(const CellCheckItem& item, double number);
/// "≤ 500", "≥ 10": how the value has to lie to its limit.
[[nodiscard]] std::string limit_text(const CellCheckItem& item);

}  // namespace gripscan::ui
