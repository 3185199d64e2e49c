// Injected faults as they are asked for, NAME[@STEP][=VALUE]: which, from where on, how much.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace gripscan::sim {

enum class FaultKind {
    // of the link and the controller
    kDelay,
    kDrop,
    kGarble,
    kSplit,
    kHalfOpen,
    kRestart,
    kEmergencyStop,
    kServoOff,
    kLimit,
    // of the arm, the gripper and the camera
    kRatio,
    kBacklash,
    kSign,
    kLoose,
    kSlip,
    kGlare,
    kDefocus,
    kBump,
    kIntruder,
    kTool,
    kShift,
    kObjectSlip,
    kObjectTwist,
};

/// The moment of an exchange with the controller at which a fault of the link strikes: just before
/// the named answer would be sent; kRun half-way between acceptance and arrival, kAfterDone once
/// the answer is out.
enum class ExchangePoint { kHello, kState, kPos, kAccept, kRun, kDone, kAfterDone, kStop };

struct Fault {
    FaultKind kind = FaultKind::kDelay;
    /// Faults of arm and images: number of the nominal step, 1 from the first capture to the
    /// second. Faults of link and controller: how many J6ABS this server has received; 0: none.
    int step = 0;
    double amount = 0.0;                           ///< in the unit of the fault's table row
    ExchangePoint point = ExchangePoint::kAccept;  ///< of the faults of link and controller

    friend bool operator==(const Fault&, const Fault&) = default;
};

/// A row of the table of faults: name, defaults and limits.
struct FaultInfo {
    std::string_view name;
    Fault preset;
    std::string_view unit;  ///< of the amount; empty: the fault takes none
    double least = 0.0;     ///< the amount's limits
    double most = 0.0;
    std::string_view effect;
};

/// In the order of FaultKind.
[[nodiscard]] std::span<const FaultInfo> fault_table();
[[nodiscard]] const FaultInfo& info_of(FaultKind kind);
[[nodiscard]] std::string_view name_of(ExchangePoint point);

/// Strikes in the exchange with the controller, not in the pictures.
[[nodiscard]] constexpr bool is_of_link(FaultKind kind) {
    return kind <= FaultKind::kLimit;
}

/// VALUE is the amount; for faults of link and controller POINT, AMOUNT or POINT:AMOUNT. An
/// unknown name is answered with the known ones.
[[nodiscard]] Result<Fault> parse_fault(std::string_view text);
[[nodiscard]] Result<std::vector<Fault>> parse_faults(const std::vector<std::string>& texts);

}  // namespace gripscan::sim
