// A TCP connection that speaks in lines.
#pragma once

#include <string_view>

#include "core/concurrency/tcp_connection.h"
#include "core/robot/line_framer.h"

namespace gripscan {

/// One thread may read while another writes; close() from any.
class LineChannel {
  public:
    explicit LineChannel(TcpConnection connection) : connection_(std::move(connection)) {}

    /// The line's end is added.
    [[nodiscard]] TcpResult<void> write(std::string_view line, Deadline deadline);
    /// The next item that has come whole.
    [[nodiscard]] TcpResult<FramedItem> read(Deadline deadline);

    /// What has come of a line without its end.
    [[nodiscard]] const std::string& pending() const { return framer_.pending(); }

    void close() { connection_.close(); }
    [[nodiscard]] TcpConnection& connection() { return connection_; }

  private:
    TcpConnection connection_;
    LineFramer framer_;
};

}  // namespace gripscan
