// One capture of the turn as the procedure knows it: a line of captures.csv without its files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/registration/turn_report.h"
#include "core/robot/robot_link.h"

namespace gripscan {

enum class CaptureStatus {
    kUsed,
    kSuperseded,  ///< retaken, halved over or gone back from
    kExcluded,    ///< by the operator
};
/// "used", "superseded", "excluded": the words of captures.csv.
[[nodiscard]] std::string_view word(CaptureStatus status);

struct CaptureRecord {
    int index = 0;               ///< rises, unique, never renumbered
    int attempt = 1;             ///< at this angle
    double commanded_rad = 0.0;  ///< turn since the first capture
    CaptureStatus status = CaptureStatus::kUsed;
    TurnMode mode = TurnMode::kFree;     ///< of the step that leads to this capture
    std::string note;                    ///< the operator's, who accepted that step; empty: did not
    std::optional<RobotReading> before;  ///< the exposure; nothing where no robot could be read
    std::optional<double> joint6_after_rad;
    double t_s = 0.0;  ///< of the exposure

    friend bool operator==(const CaptureRecord&, const CaptureRecord&) = default;
};

}  // namespace gripscan
