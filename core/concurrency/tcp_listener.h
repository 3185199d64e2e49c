// Waits for TCP connections, for the servers: the simulated controller, the frames of its camera.
#pragma once

#include "core/concurrency/tcp_connection.h"

namespace gripscan {

class TcpListener {
  public:
    /// Port 0: a free one is taken; port() tells it.
    [[nodiscard]] static TcpResult<TcpListener> open(std::uint16_t port,
                                                     const std::string& address = "127.0.0.1");
    TcpListener(TcpListener&&) noexcept;
    TcpListener& operator=(TcpListener&&) noexcept;
    ~TcpListener();

    [[nodiscard]] std::uint16_t port() const;

    /// One thread at a time. A stop request or close() ends it with kStopped.
    [[nodiscard]] TcpResult<TcpConnection> accept(const std::stop_token& stop,
                                                  Deadline deadline = Deadline::max());
    /// From any thread, for good: nobody can connect any more.
    void close();

  private:
    struct Impl;
    explicit TcpListener(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> impl_;
};

}  // namespace gripscan
