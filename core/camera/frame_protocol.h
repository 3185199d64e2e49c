// The frame port: stereo pairs on request over TCP. Messages as values, to and from bytes; the bytes
// are described in docs/frame-port.md. Both ends use these functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/camera/stereo_source.h"
#include "core/geometry/box.h"

namespace gripscan::frames {

inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::size_t kHeaderBytes = 12;
inline constexpr std::size_t kLongestPayload = 64U << 20U;  ///< more is no message of this protocol

/// What a client needs to know of the cell besides its pictures.
struct Description {
    StereoRig rig;
    std::optional<Box> region;                 ///< registration area, camera frame
    std::optional<Eigen::Vector3d> axis_hint;  ///< direction of the positive turn of joint 6
};

// From the client.
struct AskDescription {};
using AskFrame = FrameRequest;

// From the server. It greets whoever connects.
struct Greeting {
    std::uint32_t version = kVersion;
};
struct Refusal {
    std::string why;  ///< one line, UTF-8
};

using Message =
    std::variant<AskDescription, AskFrame, Greeting, Description, StereoFrame, Refusal>;

[[nodiscard]] std::string encode(const Message& message);

/// What stands in front of every message.
struct Header {
    std::uint32_t type = 0;
    std::size_t payload_bytes = 0;
};

/// From kHeaderBytes bytes; an error if they begin no message or one that is too long.
[[nodiscard]] Result<Header> decode_header(std::string_view bytes);
/// An error if the payload is no message of that type, down to its last byte.
[[nodiscard]] Result<Message> decode(const Header& header, std::string_view payload);

}  // namespace gripscan::frames
