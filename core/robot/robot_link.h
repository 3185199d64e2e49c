// What gripscan wants of a robot: say where the joints are, turn the last one to an angle, stop.
#pragma once

#include <array>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/geometry/pose.h"

namespace gripscan {

/// J1 … J6 in rad, FANUC convention (J3 is measured against the horizontal: J3_urdf = J3 + J2).
using JointAngles = std::array<double, 6>;

/// A robot as it reports itself.
struct RobotReading {
    JointAngles joints_rad{};
    Pose T_world_tool = Pose::Identity();  ///< tool0 in FANUC WORLD, m

    friend bool operator==(const RobotReading& a, const RobotReading& b) {
        return a.joints_rad == b.joints_rad && a.T_world_tool.matrix() == b.T_world_tool.matrix();
    }
};

/// Who is at the other end.
struct RobotIdentity {
    std::string model;
    int axes = 0;
    std::string protocol;  ///< name and version, e.g. "GSP/1.0"
};

/// What the controller says about itself, received and never inferred.
struct ControllerState {
    bool automatic = false;
    bool servo_on = false;
    bool emergency_stop = false;
    bool fault = false;
    bool moving = false;
    int override_percent = 0;
    std::string alarm;  ///< such as "SRVO-002"; empty: none
};

/// What kind of trouble, so that a caller knows what may be done next.
enum class RobotFault {
    kUnreachable,  ///< nobody answers, or it is no robot of this dialect
    kLost,         ///< the link went in mid-exchange: whether the joint moves is unknown
    kTimeout,      ///< no answer in time: whether the joint moves is unknown
    kProtocol,     ///< what came makes no sense in this dialect
    kRefused,      ///< not in AUTO, servo off, emergency stop, fault, pendant enabled, busy
    kOutOfRange,   ///< target, step or speed beyond a limit: nothing moved
    kStaleId,      ///< a command id that the controller has passed: `last_id` tells it
    kStopped,      ///< the motion ended because it was told to
    kOffTarget,    ///< the motion ended somewhere else, or took too long
    kOtherJoint,   ///< joints 1 … 5 are not where they were: what the turn was for is void
    kInternal,     ///< the controller's own failure
};
/// "unreachable", "lost", "out_of_range", …: for the journal.
[[nodiscard]] std::string_view word(RobotFault fault);

struct RobotError {
    RobotFault fault = RobotFault::kLost;
    int code = 0;         ///< of the dialect; 0: none
    int last_id = 0;      ///< with kStaleId
    std::string message;  ///< one line, complete without context
    /// Must the joint be read before anything else is asked?
    [[nodiscard]] bool motion_unknown() const {
        return fault == RobotFault::kLost || fault == RobotFault::kTimeout;
    }
};

template <typename T>
using RobotResult = tl::expected<T, RobotError>;

/// As an error of the device, for callers that only report.
[[nodiscard]] inline Error as_error(const RobotError& error) {
    return {ErrorKind::kDevice, error.message};
}

/// Turn joint 6 to an absolute angle. The id makes the command repeatable: sent again with the same
/// arguments it never turns the joint twice. Ids rise; the caller journals one before using it.
struct Joint6Command {
    int id = 0;  ///< 1 … 2147483647
    double angle_rad = 0.0;
    double speed_percent = 10.0;
};

/// One sign of life of the monitor connection.
struct RobotBeat {
    bool alive = false;
    RobotReading reading;       ///< valid while alive
    double round_trip_s = 0.0;  ///< of this beat
    std::string trouble;        ///< why it is not alive
};

/// Blocking calls with time-outs of their own; none hangs. read(), state() and stop() may be called
/// from any thread, while a turn is going on too; the others from one thread at a time.
class RobotLink {
  public:
    virtual ~RobotLink() = default;

    /// Opens the connections, again after a loss too.
    [[nodiscard]] virtual RobotResult<RobotIdentity> connect() = 0;
    virtual void disconnect() = 0;

    [[nodiscard]] virtual RobotResult<ControllerState> state() = 0;
    [[nodiscard]] virtual RobotResult<RobotReading> read() = 0;

    /// Returns the reading once the arm stands still at the target. A stop request stops the arm
    /// and ends with kStopped.
    [[nodiscard]] virtual RobotResult<RobotReading> turn_joint6(const Joint6Command& command,
                                                                std::stop_token stop) = 0;
    /// Stops whatever moves. Not a safety function.
    [[nodiscard]] virtual RobotResult<void> stop() = 0;

    /// Told of every heartbeat, from a thread of the link; an empty function: nobody. Set before
    /// connect().
    virtual void on_beat(std::function<void(const RobotBeat&)> receiver) = 0;
};

}  // namespace gripscan
