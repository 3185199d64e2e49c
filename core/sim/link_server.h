// One link of the simulated controller: a port that serves one client at a time, as a real one does.
#pragma once

#include <thread>

#include "core/sim/cabinet.h"

namespace gripscan {
class TcpListener;
}

namespace gripscan::sim {

/// Serves from its construction to its end, on a thread of its own.
class LinkServer {
  public:
    /// `cabinet` must outlive it.
    LinkServer(TcpListener listener, LinkKind link, Cabinet& cabinet);
    ~LinkServer();

    [[nodiscard]] std::uint16_t port() const { return port_; }

  private:
    std::uint16_t port_;
    std::jthread thread_;
};

}  // namespace gripscan::sim
