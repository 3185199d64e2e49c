#include "core/sim/fault_plan.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/number_text.h"

namespace gripscan::sim {
namespace {

using enum FaultKind;
using enum ExchangePoint;

constexpr int kStep = 5;  ///< where a fault begins that is not told where
constexpr double kAnHour_s = 3600.0;

// clang-format off
constexpr std::array<FaultInfo, 22> kFaults = {{
    {"delay",     {kDelay, kStep, 3.0, kAccept},       "s",   0.0, kAnHour_s, "the answer comes late"},
    {"drop",      {kDrop, kStep, 0.0, kDone},          "",    0.0, 0.0,  "the connection is closed instead of the answer"},
    {"garble",    {kGarble, kStep, 0.0, kDone},        "",    0.0, 0.0,  "the answer arrives as other letters"},
    {"split",     {kSplit, kStep, 0.002, kDone},       "s",   0.0, 1.0,  "the answer comes byte by byte, so much time between them"},
    {"halfopen",  {kHalfOpen, kStep, 0.0, kAccept},    "",    0.0, 0.0,  "the connection stays open and says nothing more"},
    {"restart",   {kRestart, kStep, 1.0, kRun},        "s",   0.0, kAnHour_s, "the controller starts again, away for so long: the arm stops, ids are forgotten"},
    {"estop",     {kEmergencyStop, kStep, 0.0, kRun},  "s",   0.0, kAnHour_s, "emergency stop, released after so long; 0: never"},
    {"servo_off", {kServoOff, kStep, 0.0, kRun},       "s",   0.0, kAnHour_s, "the servos switch off, on again after so long; 0: never"},
    {"limit",     {kLimit, kStep, 0.0, kAccept},       "deg", 0.0, 360.0, "joint 6 may go no further than this from where it stands"},
    {"ratio",     {kRatio, 1, 1.05, kAccept},          "",    0.5, 2.0,  "joint 6 turns so many times what it reports"},
    {"backlash",  {kBacklash, kStep, 0.8, kAccept},    "deg", 0.0, 10.0, "the joint lags by the play once the weight has passed the top"},
    {"sign",      {kSign, 1, 0.0, kAccept},            "",    0.0, 0.0,  "joint 6 turns the other way"},
    {"loose",     {kLoose, kStep, 3.0, kAccept},       "deg", 0.0, 10.0, "the gripper tilts and shifts anew at every angle"},
    {"slip",      {kSlip, kStep, 2.5, kAccept},        "mm",  -20.0, 20.0, "the gripper has moved along its axis"},
    {"glare",     {kGlare, kStep, 45.0, kAccept},      "px",  1.0, 400.0, "a saturated spot of this radius on the gripper, in the first attempt"},
    {"defocus",   {kDefocus, kStep, 4.0, kAccept},     "px",  0.0, 20.0, "the lens blurs by this standard deviation"},
    {"bump",      {kBump, kStep, 4.0, kAccept},        "mm",  0.0, 50.0, "the camera is shifted by this and turned by 0.1 deg a mm"},
    {"intruder",  {kIntruder, kStep, 40.0, kAccept},   "mm",  5.0, 100.0, "a finger-like thing of this thickness before the gripper"},
    {"tool",      {kTool, kStep, 150.0, kAccept},      "mm",  40.0, 300.0, "a screwdriver of this length, left in the registration area"},
    {"shift",     {kShift, kStep, 2.0, kAccept},       "mm",  0.0, 50.0, "table, wall and fixtures stand elsewhere by this"},
    {"object_slip", {kObjectSlip, kStep, 2.0, kAccept}, "mm", -20.0, 20.0, "the object has slid between the fingers"},
    {"object_twist", {kObjectTwist, kStep, 3.0, kAccept}, "deg", -30.0, 30.0, "the object has turned between the fingers"},
}};
// clang-format on

constexpr std::array<std::string_view, 8> kPoints = {"hello", "state", "pos",        "accept",
                                                     "run",   "done",  "after_done", "stop"};

/// Takes what follows the mark off the text; nothing if the mark is not there.
std::optional<std::string_view> take_after(std::string_view& text, char mark) {
    const auto at = text.find(mark);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view after = text.substr(at + 1);
    text = text.substr(0, at);
    return after;
}

Status read_step(std::string_view text, Fault& fault) {
    const auto number = number_from_text(text);
    if (!number || *number != std::floor(*number) || *number < 0 || *number > 100000) {
        return input_error("fault {}: the step '{}' is no number from 0 to 100000",
                           info_of(fault.kind).name, text);
    }
    fault.step = static_cast<int>(*number);
    return {};
}

Status read_amount(std::string_view text, Fault& fault) {
    const FaultInfo& info = info_of(fault.kind);
    if (info.least == info.most) {
        return input_error("fault {} takes no amount, and '{}' was given", info.name, text);
    }
    const auto number = number_from_text(text);
    if (!number || *number < info.least || *number > info.most) {
        return input_error("fault {}: '{}' is no amount from {} to {}{}{}", info.name, text,
                           info.least, info.most, info.unit.empty() ? "" : " ", info.unit);
    }
    fault.amount = *number;
    return {};
}

/// POINT, AMOUNT or POINT:AMOUNT.
Status read_value_of_link(std::string_view text, Fault& fault) {
    const auto amount = take_after(text, ':');
    const auto point = std::find(kPoints.begin(), kPoints.end(), text);
    if (point != kPoints.end()) {
        fault.point = static_cast<ExchangePoint>(point - kPoints.begin());
        return amount ? read_amount(*amount, fault) : Status{};
    }
    if (amount || !number_from_text(text)) {
        return input_error("fault {}: '{}' is no point of the exchange; there are {}",
                           info_of(fault.kind).name, text, fmt::join(kPoints, ", "));
    }
    return read_amount(text, fault);
}

}  // namespace

std::span<const FaultInfo> fault_table() {
    return kFaults;
}

const FaultInfo& info_of(FaultKind kind) {
    return kFaults.at(static_cast<std::size_t>(kind));
}

std::string_view name_of(ExchangePoint point) {
    return kPoints.at(static_cast<std::size_t>(point));
}

Result<Fault> parse_fault(std::string_view text) {
    std::string_view name = text;
    const auto value = take_after(name, '=');
    const auto step = take_after(name, '@');
    const auto info = std::find_if(kFaults.begin(), kFaults.end(),
                                   [&](const FaultInfo& row) { return row.name == name; });
    if (info == kFaults.end()) {
        std::vector<std::string_view> names;
        for (const FaultInfo& row : kFaults) names.push_back(row.name);
        return input_error("no fault is called '{}'; there are {}", name, fmt::join(names, ", "));
    }
    Fault fault = info->preset;
    if (step) {
        if (Status ok = read_step(*step, fault); !ok) return forward_error(ok.error());
    }
    if (value) {
        const Status ok =
            is_of_link(fault.kind) ? read_value_of_link(*value, fault) : read_amount(*value, fault);
        if (!ok) return forward_error(ok.error());
    }
    return fault;
}

Result<std::vector<Fault>> parse_faults(const std::vector<std::string>& texts) {
    std::vector<Fault> faults;
    for (const std::string& text : texts) {
        const auto fault = parse_fault(text);
        if (!fault) return forward_error(fault.error());
        faults.push_back(*fault);
    }
    return faults;
}

}  // namespace gripscan::sim
