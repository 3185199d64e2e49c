// Error codes of GSP/1: what each means, and what kind of trouble it is.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/robot/robot_link.h"

namespace gripscan::gsp {

enum class ErrorCode : int {
    kMalformed = 100,
    kUnknownRequest = 101,
    kVersion = 102,
    kNotAutomatic = 200,
    kServoOff = 201,
    kEmergencyStop = 202,
    kFault = 203,
    kPendant = 204,
    kTargetRange = 300,
    kStepCap = 301,
    kSpeedRange = 302,
    kBusy = 303,
    kStaleId = 304,
    kStopped = 410,
    kOffTarget = 411,
    kMotionTime = 412,
    kProgramFailed = 413,
    kInternal = 500,
};

struct ErrorRow {
    ErrorCode code;
    RobotFault fault;
    std::string_view words;  ///< what the code means
    std::string_view advice;
};

/// Every code of the protocol, rising.
[[nodiscard]] std::span<const ErrorRow> error_table();

/// A code outside the table takes its kind from its hundreds.
[[nodiscard]] RobotFault fault_of(ErrorCode code);
[[nodiscard]] std::string_view words_of(ErrorCode code);

/// The id in "last=<n> …", the text of a kStaleId.
[[nodiscard]] std::optional<int> last_id_in(std::string_view text);
[[nodiscard]] std::string stale_text(int last_id, std::string_view why);

/// What the controller's refusal means to a caller: one complete sentence.
[[nodiscard]] RobotError robot_error(ErrorCode code, std::string_view text);

}  // namespace gripscan::gsp
