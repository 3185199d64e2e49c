// GSP/1, the line protocol between gripscan and the controller: its messages as values, to and from
// text. Both ends use these functions. Lines here have no end; core/robot/line_framer.h adds it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/robot/gsp_error.h"
#include "core/robot/robot_link.h"

namespace gripscan::gsp {

inline constexpr int kVersion = 1;
inline constexpr std::string_view kVersionText = "GSP/1.0";
inline constexpr std::uint16_t kMotionPort = 18740;  ///< monitor: the next one
inline constexpr int kAxes = 6;

// Requests.

struct Hello {
    int version = kVersion;
};
struct AskState {};
struct AskPosition {};
/// Joint 6 to an absolute angle.
struct TurnJoint6 {
    int id = 0;  ///< 1 … 2147483647
    double angle_deg = 0.0;
    double speed_percent = 0.0;
    bool operator==(const TurnJoint6&) const = default;
};
struct Stop {};

using Request = std::variant<Hello, AskState, AskPosition, TurnJoint6, Stop>;

// Replies. What the controller does not know is empty ("-").

struct HelloReply {
    std::string model;  ///< one word
    int axes = 0;
    std::string version;  ///< one word
};
struct StateReply {
    std::optional<bool> automatic, servo_on, emergency_stop, fault, moving;
    std::optional<int> override_percent;  ///< 0 … 100
    std::string alarm;                    ///< empty: none
};
struct Position {
    std::optional<std::int64_t> time_ms;
    std::array<std::optional<double>, 6> joints_deg;  ///< FANUC's J1 … J6
    std::array<std::optional<double>, 6> xyzwpr;      ///< mm and deg, in the active frames
    std::optional<int> uframe, utool;
};
struct PositionReply {
    Position position;
};
struct Accepted {
    int id = 0;
};
struct Done {
    int id = 0;
    Position position;
};
struct StopReply {};
struct Failure {
    int id = 0;  ///< 0: of no turn
    ErrorCode code = ErrorCode::kInternal;
    std::string text;
};

using Reply =
    std::variant<HelloReply, StateReply, PositionReply, Accepted, Done, StopReply, Failure>;

/// At most 200 characters; free text is cut there, and what is no printable ASCII becomes '?'.
[[nodiscard]] std::string encode(const Request& request);
[[nodiscard]] std::string encode(const Reply& reply);

/// A Failure is the answer that the line deserves (kMalformed or kUnknownRequest). The version of a
/// Hello is any number: whether it is spoken, the server says.
[[nodiscard]] tl::expected<Request, Failure> decode_request(std::string_view line);
/// The error is of kind kProtocol and quotes the line.
[[nodiscard]] RobotResult<Reply> decode_reply(std::string_view line);

/// "ERR 0 100 …", for a line of 201 … 254 characters.
[[nodiscard]] Failure too_long();

}  // namespace gripscan::gsp
