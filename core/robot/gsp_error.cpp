#include "core/robot/gsp_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace gripscan::gsp {
namespace {

constexpr std::array<ErrorRow, 18> kTable{{
    {ErrorCode::kMalformed, RobotFault::kProtocol, "malformed line", "versions may differ"},
    {ErrorCode::kUnknownRequest, RobotFault::kProtocol, "unknown request", "versions may differ"},
    {ErrorCode::kVersion, RobotFault::kProtocol, "protocol version not spoken",
     "load the server of this version on the controller"},
    {ErrorCode::kNotAutomatic, RobotFault::kRefused, "not in AUTO", "turn the key to AUTO"},
    {ErrorCode::kServoOff, RobotFault::kRefused, "servo off", "switch the servos on"},
    {ErrorCode::kEmergencyStop, RobotFault::kRefused, "emergency stop",
     "release it and reset on the controller"},
    {ErrorCode::kFault, RobotFault::kRefused, "fault", "clear the alarm on the controller"},
    {ErrorCode::kPendant, RobotFault::kRefused, "pendant enabled", "switch the pendant off"},
    {ErrorCode::kTargetRange, RobotFault::kOutOfRange, "target out of range", "nothing moved"},
    {ErrorCode::kStepCap, RobotFault::kOutOfRange, "step above the configured cap",
     "nothing moved; take smaller steps"},
    {ErrorCode::kSpeedRange, RobotFault::kOutOfRange, "speed outside 1 to its cap",
     "nothing moved; lower the speed"},
    {ErrorCode::kBusy, RobotFault::kRefused, "busy with another turn", "wait until it has ended"},
    {ErrorCode::kStaleId, RobotFault::kStaleId, "stale or conflicting id",
     "nothing moved; go on from the id it names"},
    {ErrorCode::kStopped, RobotFault::kStopped, "stopped on request", "read the joint"},
    {ErrorCode::kOffTarget, RobotFault::kOffTarget, "ended off target", "read the joint"},
    {ErrorCode::kMotionTime, RobotFault::kOffTarget, "motion exceeded its time limit",
     "read the joint"},
    {ErrorCode::kProgramFailed, RobotFault::kInternal, "the program on the controller failed",
     "see its pendant"},
    {ErrorCode::kInternal, RobotFault::kInternal, "internal error of the controller",
     "see its pendant"},
}};

const ErrorRow* row_of(ErrorCode code) {
    const auto row = std::find_if(kTable.begin(), kTable.end(),
                                  [&](const ErrorRow& r) { return r.code == code; });
    return row == kTable.end() ? nullptr : &*row;
}

}  // namespace

std::span<const ErrorRow> error_table() {
    return kTable;
}

RobotFault fault_of(ErrorCode code) {
    if (const ErrorRow* row = row_of(code)) return row->fault;
    switch (static_cast<int>(code) / 100) {
        case 1:
            return RobotFault::kProtocol;
        case 2:
            return RobotFault::kRefused;
        case 3:
            return RobotFault::kOutOfRange;
        case 4:
            return RobotFault::kOffTarget;
        default:
            return RobotFault::kInternal;
    }
}

std::string_view words_of(ErrorCode code) {
    const ErrorRow* row = row_of(code);
    return row ? row->words : "unlisted code";
}

std::optional<int> last_id_in(std::string_view text) {
    constexpr std::string_view kKey = "last=";
    if (!text.starts_with(kKey)) return std::nullopt;
    text.remove_prefix(kKey.size());
    int id = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
    const bool whole = end == text.data() + text.size() || *end == ' ';
    if (error != std::errc{} || !whole || id < 0) return std::nullopt;
    return id;
}

std::string stale_text(int last_id, std::string_view why) {
    return fmt::format("last={} {}", last_id, why);
}

RobotError robot_error(ErrorCode code, std::string_view text) {
    const ErrorRow* row = row_of(code);
    RobotError error;
    error.fault = fault_of(code);
    error.code = static_cast<int>(code);
    if (error.fault == RobotFault::kStaleId) error.last_id = last_id_in(text).value_or(0);
    error.message =
        fmt::format("the controller answers {} ({}{}{}){}{}", error.code, words_of(code),
                    text.empty() ? "" : ": ", text, row ? "; " : "", row ? row->advice : "");
    return error;
}

}  // namespace gripscan::gsp
