#include "core/concurrency/tcp_listener.h"

#include <fmt/format.h>

#include <asio.hpp>
#include <atomic>
#include <cerrno>

namespace gripscan {
namespace {
using asio::ip::tcp;

tl::unexpected<TcpError> failed(TcpFault fault, std::string message) {
    return tl::unexpected<TcpError>(TcpError{fault, std::move(message)});
}

std::string peer_of(const tcp::socket& socket) {
    asio::error_code error;
    const auto endpoint = socket.remote_endpoint(error);
    if (error) return "a client";
    return fmt::format("{}:{}", endpoint.address().to_string(), endpoint.port());
}

}  // namespace

struct TcpListener::Impl {
    asio::io_context io;
    tcp::acceptor acceptor{io};
    std::uint16_t port = 0;
    std::atomic<bool> closed = false;

    void close() {
        closed = true;
        io.stop();
    }

    asio::error_code listen(const tcp::endpoint& endpoint) {
        asio::error_code error;
        acceptor.open(endpoint.protocol(), error);
        // A server that is started again need not wait for the old connections to fade away.
        if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
        if (!error) acceptor.bind(endpoint, error);
        if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
        if (!error) port = acceptor.local_endpoint(error).port();
        return error;
    }
};

TcpListener::TcpListener(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
TcpListener::TcpListener(TcpListener&&) noexcept = default;
TcpListener& TcpListener::operator=(TcpListener&&) noexcept = default;
TcpListener::~TcpListener() = default;

TcpResult<TcpListener> TcpListener::open(std::uint16_t port, const std::string& address) {
    asio::error_code error;
    const auto ip = asio::ip::make_address(address == "localhost" ? "127.0.0.1" : address, error);
    if (error) return failed(TcpFault::kAddress, fmt::format("'{}' is no address", address));
    auto impl = std::make_unique<Impl>();
    error = impl->listen({ip, port});
    if (!error) return TcpListener(std::move(impl));
    const bool taken = error == asio::error::address_in_use;
    const bool elsewhere = error.value() == EADDRNOTAVAIL;
    return failed(taken       ? TcpFault::kRefused
                  : elsewhere ? TcpFault::kAddress
                              : TcpFault::kFailed,
                  fmt::format("cannot listen on {}:{}: {}{}", address, port, error.message(),
                              taken ? "; another program has the port, 0 picks a free one" : ""));
}

std::uint16_t TcpListener::port() const {
    return impl_->port;
}

TcpResult<TcpConnection> TcpListener::accept(const std::stop_token& stop, Deadline deadline) {
    impl_->io.restart();
    if (impl_->closed) return failed(TcpFault::kStopped, "the server was closed");
    tcp::socket socket(impl_->io);
    asio::error_code error = asio::error::would_block;
    impl_->acceptor.async_accept(socket, [&](const asio::error_code& result) { error = result; });
    {
        const std::stop_callback on_stop(stop, [&] { impl_->io.stop(); });
        if (deadline == Deadline::max()) {
            impl_->io.run();
        } else {
            impl_->io.run_until(deadline);
        }
    }
    if (error == asio::error::would_block) {
        asio::error_code ignored;
        impl_->acceptor.cancel(ignored);
        impl_->io.restart();
        impl_->io.run();  // the handler, which refers to this frame
        const bool stopped = impl_->closed || stop.stop_requested();
        if (stopped) return failed(TcpFault::kStopped, "waiting for clients was stopped");
        if (error) return failed(TcpFault::kTimeout, "no client came in time");
    }
    if (error) {
        return failed(TcpFault::kFailed, fmt::format("cannot accept clients on port {}: {}",
                                                     impl_->port, error.message()));
    }
    const std::string peer = peer_of(socket);
    const bool is_v6 = socket.local_endpoint(error).protocol() == tcp::v6();
    const int native_socket = socket.release(error);
    if (error) return failed(TcpFault::kFailed, "a client was lost: " + error.message());
    return TcpConnection::adopt(native_socket, is_v6, peer);
}

void TcpListener::close() {
    impl_->close();
}

}  // namespace gripscan
