#include "core/procedure/auto_turn.h"

#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/base/units.h"

namespace gripscan {
namespace {

std::string deg_text(double rad) {
    return text_from_number(deg_from_rad(rad));
}

/// Angles of a command are met to this; the difference shows a robot that stopped on the way.
constexpr double kArrivedRad = 0.5 * kRadPerDeg;

Status check_range(const AutoTurnSettings& settings, int steps) {
    const double end = settings.start_joint6_rad + steps * settings.step_rad;
    if (std::max(std::abs(end), std::abs(settings.start_joint6_rad)) >
        settings.joint6_limit_rad + 1e-9) {
        return input_error(
            "joint 6 would turn from {:.1f} to {:.1f} deg, beyond its +-{:.0f} deg; "
            "start further back",
            deg_from_rad(settings.start_joint6_rad), deg_from_rad(end),
            deg_from_rad(settings.joint6_limit_rad));
    }
    return {};
}

/// Drives to the angle and makes sure that the robot got there.
Status go_to(RobotLink& robot, double angle_rad, int id, Journal& journal) {
    Status noted =
        journal.write("command", {{"verb", "turn_joint6"}, {"to_deg", deg_text(angle_rad)}});
    if (!noted) return noted;
    const auto reading = robot.turn_joint6({id, angle_rad}, {});
    if (!reading) return forward_error(as_error(reading.error()));
    if (std::abs(reading->joints_rad[5] - angle_rad) > kArrivedRad) {
        return device_error(
            "joint 6 stands at {:.3f} deg instead of {:.3f} deg; the robot did not "
            "finish its motion",
            deg_from_rad(reading->joints_rad[5]), deg_from_rad(angle_rad));
    }
    return journal.write(
        "result", {{"verb", "turn_joint6"}, {"joint6_deg", deg_text(reading->joints_rad[5])}});
}

Result<TakenCapture> take_capture(RobotLink& robot, StereoSource& source, int index) {
    TakenCapture capture;
    capture.index = index;
    auto before = robot.read();
    if (!before) return forward_error(as_error(before.error()));
    auto frame = source.grab({index, 1});
    if (!frame) return forward_error(frame.error());
    auto after = robot.read();
    if (!after) return forward_error(as_error(after.error()));
    capture.before = *before;
    capture.after = *after;
    capture.frame = std::move(*frame);
    return capture;
}

}  // namespace

int steps_of_turn(double step_rad) {
    return static_cast<int>(std::lround(2.0 * std::numbers::pi / step_rad));
}

Status take_turn(RobotLink& robot, StereoSource& source, const AutoTurnSettings& settings,
                 TurnStore& store, Journal& journal, const Progress& progress) {
    if (!(settings.step_rad > 0.0) || settings.step_rad > std::numbers::pi) {
        return input_error("the step must be above 0 and at most 180 deg, not {:.3f} deg",
                           deg_from_rad(settings.step_rad));
    }
    const int steps = steps_of_turn(settings.step_rad);
    if (Status status = check_range(settings, steps); !status) return status;
    const auto total = static_cast<std::size_t>(steps) + 1;
    for (int k = 0; k <= steps; ++k) {
        progress.tell("capture", static_cast<std::size_t>(k), total);
        if (progress.cancelled()) return cancelled_error();
        const double turn_rad = k * settings.step_rad;
        const double angle_rad = settings.start_joint6_rad + turn_rad;
        if (Status s = go_to(robot, angle_rad, k + 1, journal); !s) return s;
        auto capture = take_capture(robot, source, k);
        if (!capture) return forward_error(capture.error());
        capture->commanded_rad = turn_rad;
        if (Status s = store.store(*capture); !s) return s;
        Status noted =
            journal.write("capture", {{"index", fmt::format("{}", k)},
                                      {"commanded_deg", deg_text(turn_rad)},
                                      {"joint6_deg", deg_text(capture->before.joints_rad[5])}});
        if (!noted) return noted;
    }
    progress.tell("capture", total, total);
    return {};
}

}  // namespace gripscan
