// The words of the contract: verdicts, causes, modes; and the limits they are held against.
#pragma once

#include <string_view>

namespace gripscan {

enum class Verdict { kAccept, kCheck, kReject, kAcceptNoted };
enum class Cause {
    kNone,
    kOverlap,
    kSymmetry,
    kTexture,
    kExposure,
    kSettle,
    kWrongJoint,
    kRatio,
    kBacklash,
    kSign,
    kSlip,
    kLoose,
    kMovedCamera,
    kMislabelled,
    kDepthDistortion,
    kNotConverged,
    kLink,
};
enum class TurnMode { kFree, kPrior, kAxisLocked };
enum class SignSource { kAxisHint, kJoint, kAssumed };

/// The words of the contract: "accept", "wrong_joint", "axis-locked", …
[[nodiscard]] std::string_view word(Verdict verdict);
[[nodiscard]] std::string_view word(Cause cause);
[[nodiscard]] std::string_view word(TurnMode mode);
[[nodiscard]] std::string_view word(SignSource source);

/// Limits of a step, with the defaults of the contract.
struct TurnLimits {
    double angle_rad = 0.5 * 0.017453292519943295;
    double sigmas = 3.0;
    double overlap = 0.4;
    double slip_m = 1.0e-3;
    double tilt_rad = 2.0 * 0.017453292519943295;
};

}  // namespace gripscan
