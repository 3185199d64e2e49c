// A TCP connection that speaks the messages of the frame port.
#pragma once

#include "core/camera/frame_protocol.h"
#include "core/concurrency/tcp_connection.h"

namespace gripscan::frames {

class FrameChannel {
  public:
    explicit FrameChannel(TcpConnection connection) : connection_(std::move(connection)) {}

    [[nodiscard]] TcpResult<void> write(const Message& message, Deadline deadline);
    /// What had come of a message before the deadline is kept for the next call. After any other
    /// error, and after bytes that make no sense (kFailed), the connection is of no use.
    [[nodiscard]] TcpResult<Message> read(Deadline deadline);

    void close() { connection_.close(); }

  private:
    TcpConnection connection_;
    std::string received_;
};

}  // namespace gripscan::frames
