// Listeners on neighbouring ports.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/concurrency/tcp_listener.h"

namespace gripscan::sim {

/// `count` listeners on the loopback address, on `port` and those after it. With port 0 free ones
/// are taken: neighbours where possible. The error names the port that is taken.
[[nodiscard]] Result<std::vector<TcpListener>> open_listeners(std::uint16_t port,
                                                              std::size_t count);

}  // namespace gripscan::sim
