#include "core/sim/free_ports.h"

namespace gripscan::sim {
namespace {

Result<std::vector<TcpListener>> open_row(std::uint16_t first, std::size_t count) {
    std::vector<TcpListener> listeners;
    for (std::size_t i = 0; i < count; ++i) {
        // The first may be port 0; what follows are its neighbours.
        const std::size_t port = i == 0 ? first : listeners.front().port() + i;
        if (port > 65535) return device_error("there is no port {}; start below it", port);
        auto listener = TcpListener::open(static_cast<std::uint16_t>(port));
        if (!listener) return device_error("simulated cell: {}", listener.error().message);
        listeners.push_back(std::move(*listener));
    }
    return listeners;
}

}  // namespace

Result<std::vector<TcpListener>> open_listeners(std::uint16_t port, std::size_t count) {
    auto listeners = open_row(port, count);
    if (port != 0) return listeners;
    constexpr int kAttempts = 20;  // a free port whose neighbours are taken is no rarity
    for (int i = 1; !listeners && i < kAttempts; ++i) listeners = open_row(0, count);
    if (listeners) return listeners;
    std::vector<TcpListener> anywhere;
    for (std::size_t i = 0; i < count; ++i) {
        auto one = open_row(0, 1);
        if (!one) return one;
        anywhere.push_back(std::move(one->front()));
    }
    return anywhere;
}

}  // namespace gripscan::sim
