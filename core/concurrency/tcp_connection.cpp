#include "core/concurrency/tcp_connection.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <asio.hpp>
#include <atomic>

namespace gripscan {
namespace {
using asio::ip::tcp;

tl::unexpected<TcpError> failed(TcpFault fault, std::string message) {
    return tl::unexpected<TcpError>(TcpError{fault, std::move(message)});
}

TcpFault fault_of(const asio::error_code& error) {
    if (error == asio::error::connection_refused) return TcpFault::kRefused;
    if (error == asio::error::eof || error == asio::error::connection_reset ||
        error == asio::error::broken_pipe || error == asio::error::connection_aborted) {
        return TcpFault::kClosed;
    }
    if (error == asio::error::timed_out) return TcpFault::kTimeout;
    return TcpFault::kFailed;
}

TcpResult<std::vector<tcp::endpoint>> endpoints_of(asio::io_context& io, const std::string& host,
                                                   std::uint16_t port) {
    asio::error_code error;
    const auto address = asio::ip::make_address(host, error);
    if (!error) return std::vector<tcp::endpoint>{{address, port}};
    if (host == "localhost") {
        return std::vector<tcp::endpoint>{{asio::ip::address_v4::loopback(), port}};
    }
    tcp::resolver resolver(io);
    std::vector<tcp::endpoint> endpoints;
    for (const auto& entry : resolver.resolve(host, std::to_string(port), error)) {
        endpoints.push_back(entry.endpoint());
    }
    if (endpoints.empty()) {
        return failed(
            TcpFault::kAddress,
            fmt::format("no host '{}': {}; give its name or its address", host, error.message()));
    }
    return endpoints;
}

/// For poll(): whole milliseconds, rounded up, at most a minute at a time.
int milliseconds_until(Deadline deadline) {
    using std::chrono::milliseconds;
    const auto now = std::chrono::steady_clock::now();
    if (deadline <= now) return 0;
    if (deadline - now > std::chrono::minutes(1)) return 60'000;
    return static_cast<int>(std::chrono::ceil<milliseconds>(deadline - now).count());
}

}  // namespace

std::string place_of(const std::string& host, std::uint16_t port) {
    const bool v6 = host.find(':') != std::string::npos;
    return v6 ? fmt::format("[{}]:{}", host, port) : fmt::format("{}:{}", host, port);
}

struct TcpConnection::Impl {
    asio::io_context io;
    tcp::socket socket{io};
    std::string peer;
    std::atomic<bool> closed = false;

    ~Impl() { close(); }

    void close() {
        if (closed.exchange(true)) return;
        // Ends the polls of other threads; the socket itself goes with its owner.
        if (socket.is_open()) ::shutdown(socket.native_handle(), SHUT_RDWR);
    }

    TcpResult<void> ready() {
        asio::error_code error;
        socket.set_option(tcp::no_delay(true), error);
        if (!error) socket.non_blocking(true, error);
        if (error) return unusable(error);
        return {};
    }

    tl::unexpected<TcpError> unusable(const asio::error_code& error) const {
        if (closed) return failed(TcpFault::kStopped, "the connection to " + peer + " was closed");
        const TcpFault fault = fault_of(error);
        if (fault == TcpFault::kClosed) return failed(fault, peer + " closed the connection");
        return failed(fault, fmt::format("the connection to {} failed: {}", peer, error.message()));
    }

    /// Waits until the socket can do something; true then, false when there is no time left.
    bool wait_for(short events, Deadline deadline) {
        for (;;) {
            pollfd entry{socket.native_handle(), events, 0};
            if (::poll(&entry, 1, milliseconds_until(deadline)) > 0) return true;
            if (std::chrono::steady_clock::now() >= deadline) return false;
        }
    }
};

TcpConnection::TcpConnection(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
TcpConnection::TcpConnection(TcpConnection&&) noexcept = default;
TcpConnection& TcpConnection::operator=(TcpConnection&&) noexcept = default;
TcpConnection::~TcpConnection() = default;

TcpResult<TcpConnection> TcpConnection::connect(const std::string& host, std::uint16_t port,
                                                Deadline deadline, const std::stop_token& stop) {
    auto impl = std::make_unique<Impl>();
    impl->peer = place_of(host, port);
    const auto endpoints = endpoints_of(impl->io, host, port);
    if (!endpoints) return tl::unexpected<TcpError>(endpoints.error());
    asio::error_code error = asio::error::would_block;
    asio::async_connect(
        impl->socket, *endpoints,
        [&](const asio::error_code& result, const tcp::endpoint&) { error = result; });
    {
        const std::stop_callback on_stop(stop, [&] { impl->io.stop(); });
        impl->io.run_until(deadline);
    }
    if (error == asio::error::would_block) {
        asio::error_code ignored;
        impl->socket.close(ignored);
        impl->io.restart();
        impl->io.run();  // the handler, which refers to this frame
        if (stop.stop_requested()) {
            return failed(TcpFault::kStopped, "connecting to " + impl->peer + " was stopped");
        }
        return failed(TcpFault::kTimeout, fmt::format("{} does not answer", impl->peer));
    }
    if (error) {
        return failed(fault_of(error),
                      fmt::format("cannot connect to {}: {}", impl->peer, error.message()));
    }
    if (const auto ready = impl->ready(); !ready) return tl::unexpected<TcpError>(ready.error());
    return TcpConnection(std::move(impl));
}

TcpResult<TcpConnection> TcpConnection::adopt(int native_socket, bool is_v6, std::string peer) {
    auto impl = std::make_unique<Impl>();
    impl->peer = std::move(peer);
    asio::error_code error;
    impl->socket.assign(is_v6 ? tcp::v6() : tcp::v4(), native_socket, error);
    if (error) return impl->unusable(error);
    if (const auto ready = impl->ready(); !ready) return tl::unexpected<TcpError>(ready.error());
    return TcpConnection(std::move(impl));
}

TcpResult<void> TcpConnection::write(std::string_view bytes, Deadline deadline) {
    while (!bytes.empty()) {
        if (impl_->closed) return impl_->unusable({});
        asio::error_code error;
        const std::size_t sent =
            impl_->socket.write_some(asio::buffer(bytes.data(), bytes.size()), error);
        bytes.remove_prefix(sent);
        if (!error) continue;
        if (error != asio::error::would_block) return impl_->unusable(error);
        if (!impl_->wait_for(POLLOUT, deadline)) {
            return failed(TcpFault::kTimeout, impl_->peer + " does not take what is sent to it");
        }
    }
    return {};
}

TcpResult<std::string> TcpConnection::read_some(Deadline deadline) {
    std::array<char, 4096> buffer;
    for (;;) {
        if (impl_->closed) return impl_->unusable({});
        asio::error_code error;
        const std::size_t count = impl_->socket.read_some(asio::buffer(buffer), error);
        if (!error) return std::string(buffer.data(), count);
        if (error != asio::error::would_block) return impl_->unusable(error);
        if (!impl_->wait_for(POLLIN, deadline)) {
            return failed(TcpFault::kTimeout, "no answer from " + impl_->peer + " in time");
        }
    }
}

void TcpConnection::close() {
    impl_->close();
}

const std::string& TcpConnection::peer() const {
    return impl_->peer;
}

}  // namespace gripscan
