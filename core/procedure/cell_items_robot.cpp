// Items about the link and the joints.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/procedure/cell_items.h"
#include "core/robot/kinematics.h"

namespace gripscan {
namespace {

constexpr double kMsPerS = 1000.0;

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

std::vector<std::string> in_the_way(const ControllerState& state) {
    std::vector<std::string> found;
    if (state.emergency_stop) found.push_back("emergency stop");
    if (state.fault) found.push_back("fault");
    if (!state.automatic) found.push_back("not in AUTO");
    if (!state.servo_on) found.push_back("servo off");
    if (state.moving) found.push_back("moving");
    if (state.override_percent <= 0) found.push_back("override 0 %");
    return found;
}

/// Room of a joint to the nearer end of its range.
double room_rad(const JointRange& range, double angle_rad) {
    return std::min(angle_rad - range.min_rad, range.max_rad - angle_rad);
}

/// Joint 6 over the turn.
struct Course {
    double now_rad = 0.0;
    double start_rad = 0.0;
    double end_rad = 0.0;
    double lowest_rad = 0.0;  ///< with the approach from below, where the range allows it
};

/// From where it stands if the turn fits, else from the lower end of the range, unless planned.
Course course_of(double now_rad, const TurnPlan& plan) {
    const JointRange& range = joint_ranges()[5];
    Course course;
    course.now_rad = now_rad;
    course.start_rad = start_of_turn(plan, now_rad);
    course.end_rad = course.start_rad + plan.total_rad;
    course.lowest_rad =
        std::min(now_rad, std::max(range.min_rad, course.start_rad - plan.approach_rad));
    return course;
}

}  // namespace

CellCheckItem link_item(const CellFacts& facts, const CellLimits& limits) {
    if (!facts.link) return skipped("link", "ms", facts.link.error());
    if (!facts.link->answers || facts.link->round_trips_s.empty()) {
        return with_sentence(at_least("link", 0, 1, "answers"), facts.link->trouble,
                             "check cable, address and the server on the controller");
    }
    const auto& trips = facts.link->round_trips_s;
    const double worst_ms = kMsPerS * *std::max_element(trips.begin(), trips.end());
    return with_sentence(at_most("link", worst_ms, limits.round_trip_ms, "ms"),
                         fmt::format("{} round trips: median {:.1f} ms, longest {:.1f} ms",
                                     trips.size(), kMsPerS * median(trips), worst_ms),
                         "look for other traffic on the network, or other tasks on the controller");
}

CellCheckItem controller_item(const CellFacts& facts, const TurnPlan& plan) {
    const std::string name = "controller";
    const std::string unit = "conditions";
    if (plan.mode == MotionMode::kManual) {
        return skipped(name, unit, "the operator moves the arm");
    }
    if (!facts.controller) return skipped(name, unit, facts.controller.error());
    const auto found = in_the_way(*facts.controller);
    CellCheckItem item = at_most(name, static_cast<double>(found.size()), 0, unit);
    if (item.outcome == CheckOutcome::kFailed && plan.mode == MotionMode::kDry) {
        item.outcome = CheckOutcome::kWarned;  // nothing is going to move
    }
    const std::string& alarm = facts.controller->alarm;
    return with_sentence(std::move(item),
                         found.empty() ? fmt::format("AUTO, servo on, no fault; override {} %",
                                                     facts.controller->override_percent)
                                       : fmt::format("{}{}", fmt::join(found, ", "),
                                                     alarm.empty() ? "" : " (" + alarm + ")"),
                         "put it right on the pendant");
}

CellCheckItem joints_item(const CellFacts& facts) {
    if (!facts.joints_rad) return skipped("joints", "deg", facts.joints_rad.error());
    JointAngles q = *facts.joints_rad;
    q[2] += q[1];  // the third range is the elbow's own angle
    std::size_t nearest = 0;
    for (std::size_t j = 1; j < q.size(); ++j) {
        if (room_rad(joint_ranges()[j], q[j]) < room_rad(joint_ranges()[nearest], q[nearest])) {
            nearest = j;
        }
    }
    const double room_deg = deg_from_rad(room_rad(joint_ranges()[nearest], q[nearest]));
    return with_sentence(at_least("joints", room_deg, 0, "deg"),
                         fmt::format("joint {} is the nearest to the end of its range: {:.1f} deg",
                                     nearest + 1, room_deg),
                         "move it back into its range");
}

std::vector<CellCheckItem> turn_items(const CellFacts& facts, const TurnPlan& plan,
                                      const CellLimits& limits) {
    if (!facts.joints_rad && !plan.start_joint6_rad) {
        const std::string& why = facts.joints_rad.error();
        return {skipped("range", "deg", why), skipped("cable", "deg", why),
                skipped("return", "deg", why)};
    }
    const JointRange& range = joint_ranges()[5];
    const double now_rad = facts.joints_rad ? (*facts.joints_rad)[5] : *plan.start_joint6_rad;
    const Course course = course_of(now_rad, plan);
    const double left_deg =
        deg_from_rad(std::min(course.start_rad - range.min_rad, range.max_rad - course.end_rad));
    const double start_deg = deg_from_rad(course.start_rad);
    const double end_deg = deg_from_rad(course.end_rad);
    const double twist_deg =
        deg_from_rad(std::max(course.end_rad - course.now_rad, course.now_rad - course.lowest_rad));
    const double inside_deg = deg_from_rad(room_rad(range, course.start_rad));
    return {
        with_sentence(at_least("range", left_deg, 0, "deg"),
                      fmt::format("joint 6 turns from {:.1f} to {:.1f} deg, its range is {:.0f} "
                                  "… {:.0f} deg",
                                  start_deg, end_deg, deg_from_rad(range.min_rad),
                                  deg_from_rad(range.max_rad)),
                      "start at a lower angle"),
        with_sentence(at_most("cable", twist_deg, limits.cable_deg, "deg"),
                      fmt::format("cables and hoses are twisted by up to {:.0f} deg from how "
                                  "they hang now",
                                  twist_deg),
                      "turn joint 6 near the start first and lay them again"),
        with_sentence(at_least("return", inside_deg, 0, "deg"),
                      fmt::format("after the turn joint 6 goes back by {:.0f} deg to {:.1f} deg, "
                                  "{:.0f} deg inside its range",
                                  end_deg - start_deg, start_deg, inside_deg),
                      "start inside the range")};
}

}  // namespace gripscan
