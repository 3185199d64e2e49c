// One TCP connection: calls that block, each with a deadline, none longer.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace gripscan {

using Deadline = std::chrono::steady_clock::time_point;

[[nodiscard]] inline Deadline deadline_in(std::chrono::milliseconds time) {
    return std::chrono::steady_clock::now() + time;
}

/// "host:port"; an IPv6 address stands in brackets.
[[nodiscard]] std::string place_of(const std::string& host, std::uint16_t port);

enum class TcpFault {
    kAddress,  ///< no such host, or no address of this machine
    kRefused,  ///< nobody listens there, or the port is taken
    kTimeout,  ///< not in time
    kClosed,   ///< by the other side
    kStopped,  ///< by close() or a stop request on this side
    kFailed,   ///< anything else; the message tells
};

struct TcpError {
    TcpFault fault = TcpFault::kFailed;
    std::string message;  ///< one line, names the peer
};

template <typename T>
using TcpResult = tl::expected<T, TcpError>;

/// One thread may read while another writes. A name is looked up by the system first, which may
/// take longer than the deadline; addresses and "localhost" do not wait.
class TcpConnection {
  public:
    [[nodiscard]] static TcpResult<TcpConnection> connect(const std::string& host,
                                                          std::uint16_t port, Deadline deadline,
                                                          const std::stop_token& stop = {});
    TcpConnection(TcpConnection&&) noexcept;
    TcpConnection& operator=(TcpConnection&&) noexcept;
    ~TcpConnection();

    /// All bytes, or an error; then it is unknown how many went out.
    [[nodiscard]] TcpResult<void> write(std::string_view bytes, Deadline deadline);
    /// At least one byte.
    [[nodiscard]] TcpResult<std::string> read_some(Deadline deadline);

    /// From any thread: read and write end at once with kStopped, and the other side is told.
    void close();

    [[nodiscard]] const std::string& peer() const;  ///< "host:port"

  private:
    friend class TcpListener;
    struct Impl;
    explicit TcpConnection(std::unique_ptr<Impl> impl);
    /// Takes over a connected socket of the system.
    static TcpResult<TcpConnection> adopt(int native_socket, bool is_v6, std::string peer);

    std::unique_ptr<Impl> impl_;
};

}  // namespace gripscan
