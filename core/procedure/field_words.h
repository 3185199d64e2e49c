// Enumerations by their words: the way back from word().
#pragma once

#include <optional>
#include <string_view>

#include "core/procedure/capture_record.h"
#include "core/procedure/cell_report.h"
#include "core/procedure/turn_plan.h"

namespace gripscan {

/// The last value of an enumeration that journals hold.
template <typename Enum>
inline constexpr Enum kLastOf = Enum::kNothingIsKnownOfThisEnumeration;
template <>
inline constexpr auto kLastOf<Verdict> = Verdict::kAcceptNoted;
template <>
inline constexpr auto kLastOf<Cause> = Cause::kLink;
template <>
inline constexpr auto kLastOf<TurnMode> = TurnMode::kAxisLocked;
template <>
inline constexpr auto kLastOf<CaptureStatus> = CaptureStatus::kExcluded;
template <>
inline constexpr auto kLastOf<CheckOutcome> = CheckOutcome::kSkipped;
template <>
inline constexpr auto kLastOf<RobotFault> = RobotFault::kInternal;
template <>
inline constexpr auto kLastOf<MotionMode> = MotionMode::kManual;

/// Nothing if no value has this word.
template <typename Enum>
[[nodiscard]] std::optional<Enum> value_of_word(std::string_view text) {
    for (int i = 0; i <= static_cast<int>(kLastOf<Enum>); ++i) {
        if (word(static_cast<Enum>(i)) == text) return static_cast<Enum>(i);
    }
    return std::nullopt;
}

}  // namespace gripscan
