// A line channel as a bad network makes it: what the controller says comes late, broken or never.
#pragma once

#include <stop_token>

#include "core/robot/line_channel.h"
#include "core/sim/cabinet.h"

namespace gripscan::sim {

class DisturbedChannel {
  public:
    explicit DisturbedChannel(TcpConnection connection) : channel_(std::move(connection)) {}

    /// False: the connection is over.
    [[nodiscard]] bool send(const Exchange& exchange, const std::stop_token& stop);
    [[nodiscard]] TcpResult<FramedItem> read(Deadline deadline) { return channel_.read(deadline); }
    /// After a half-open fault: the client is heard and never answered.
    [[nodiscard]] bool is_mute() const { return mute_; }

  private:
    [[nodiscard]] bool send_disturbed(std::string_view line, const Fault& fault,
                                      const std::stop_token& stop);
    [[nodiscard]] bool send_split(std::string_view line, double pause_s,
                                  const std::stop_token& stop);
    [[nodiscard]] bool say(std::string_view line);

    LineChannel channel_;
    bool mute_ = false;
};

}  // namespace gripscan::sim
