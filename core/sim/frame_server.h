// Serves a stereo camera on a frame port, one client at a time.
#pragma once

#include <thread>

#include "core/camera/frame_protocol.h"

namespace gripscan {
class TcpListener;
}

namespace gripscan::sim {

/// Serves from its construction to its end, on a thread of its own, and grabs on that thread.
class FrameServer {
  public:
    /// `source` must outlive it.
    FrameServer(TcpListener listener, StereoSource& source, frames::Description description);
    ~FrameServer();

    [[nodiscard]] std::uint16_t port() const { return port_; }

  private:
    std::uint16_t port_;
    std::jthread thread_;
};

}  // namespace gripscan::sim
