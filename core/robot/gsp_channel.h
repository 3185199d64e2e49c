// One connection that speaks GSP/1, from its HELLO on.
#pragma once

#include <stop_token>

#include "core/robot/gsp_settings.h"
#include "core/robot/line_channel.h"

namespace gripscan::gsp {

class GspChannel {
  public:
    /// Connects within settings.connect_limit and says HELLO. A controller that is busy answers it
    /// only once its motion has ended: `hello_limit` is how long that may take. A request to `cut`
    /// ends it at once. Any failure is of kind kUnreachable.
    [[nodiscard]] static RobotResult<GspChannel> open(const GspSettings& settings,
                                                      std::uint16_t port,
                                                      std::chrono::milliseconds hello_limit,
                                                      const std::stop_token& cut = {});
    /// The same in two steps, for what cannot wait for HELLO.
    [[nodiscard]] static RobotResult<GspChannel> connect(const GspSettings& settings,
                                                         std::uint16_t port,
                                                         const std::stop_token& cut = {});
    [[nodiscard]] RobotResult<void> greet(const GspSettings& settings,
                                          std::chrono::milliseconds hello_limit,
                                          const std::stop_token& cut = {});

    [[nodiscard]] RobotResult<void> send(const Request& request, Deadline deadline);
    /// kTimeout leaves the channel as it is; after kLost and kProtocol it is of no use.
    [[nodiscard]] RobotResult<Reply> receive(Deadline deadline);

    /// From any thread: send and receive end at once.
    void close() { lines_.close(); }

    [[nodiscard]] const RobotIdentity& identity() const { return identity_; }

  private:
    explicit GspChannel(TcpConnection connection) : lines_(std::move(connection)) {}
    [[nodiscard]] RobotResult<void> say_hello(const GspSettings& settings, Deadline deadline);

    LineChannel lines_;
    RobotIdentity identity_;
};

/// Is it the arm of the settings, speaking this version?
[[nodiscard]] RobotResult<RobotIdentity> check_identity(const HelloReply& reply,
                                                        const std::string& model);

}  // namespace gripscan::gsp
