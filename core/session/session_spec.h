// session.yaml: what a recording is of, and what it is judged by. Plain data in the file's units.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/geometry/box.h"
#include "core/registration/verdict.h"

namespace gripscan {

enum class SessionKind { kGripper, kObject, kEnvironment, kScene };
[[nodiscard]] std::string_view word(SessionKind kind);

/// Limits of a step as people write them; the defaults are the contract's.
struct LimitsDeg {
    double angle_deg = 0.5;
    double sigmas = 3.0;
    double overlap = 0.4;
    double slip_mm = 1.0;
    double tilt_deg = 2.0;
};

[[nodiscard]] TurnLimits turn_limits(const LimitsDeg& limits);
[[nodiscard]] LimitsDeg limits_deg(const TurnLimits& limits);

struct SessionSpec {
    SessionKind kind = SessionKind::kGripper;
    std::optional<double> step_deg;               ///< nominal
    std::optional<Box> region;                    ///< registration area, camera frame
    std::optional<Eigen::Vector3d> axis_hint;     ///< unit vector of the positive turn
    std::optional<std::string> gripper_template;  ///< as written; may leave the folder
    LimitsDeg limits;
};

/// Strict: unknown keys, wrong types and values that make no sense are errors with file and line.
[[nodiscard]] Result<SessionSpec> parse_session_spec(const std::filesystem::path& path,
                                                     const std::string& text);
[[nodiscard]] Result<SessionSpec> read_session_spec(const std::filesystem::path& path);
[[nodiscard]] std::string session_spec_text(const SessionSpec& spec);

}  // namespace gripscan
