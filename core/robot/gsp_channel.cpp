#include "core/robot/gsp_channel.h"

#include <fmt/format.h>

namespace gripscan::gsp {
namespace {

tl::unexpected<RobotError> failed(RobotFault fault, std::string message) {
    return tl::unexpected<RobotError>(RobotError{fault, 0, 0, std::move(message)});
}

tl::unexpected<RobotError> link_error(const TcpError& error) {
    const bool late = error.fault == TcpFault::kTimeout;
    return failed(late ? RobotFault::kTimeout : RobotFault::kLost, error.message);
}

}  // namespace

RobotResult<GspChannel> GspChannel::open(const GspSettings& settings, std::uint16_t port,
                                         std::chrono::milliseconds hello_limit,
                                         const std::stop_token& cut) {
    auto channel = connect(settings, port, cut);
    if (!channel) return channel;
    if (auto greeted = channel->greet(settings, hello_limit, cut); !greeted) {
        return tl::unexpected<RobotError>(greeted.error());
    }
    return channel;
}

RobotResult<GspChannel> GspChannel::connect(const GspSettings& settings, std::uint16_t port,
                                            const std::stop_token& cut) {
    auto connection =
        TcpConnection::connect(settings.host, port, deadline_in(settings.connect_limit), cut);
    if (!connection) {
        return failed(RobotFault::kUnreachable,
                      connection.error().message + "; is the server on the controller started?");
    }
    return GspChannel(*std::move(connection));
}

RobotResult<void> GspChannel::greet(const GspSettings& settings,
                                    std::chrono::milliseconds hello_limit,
                                    const std::stop_token& cut) {
    const std::stop_callback on_cut(cut, [this] { close(); });
    return say_hello(settings, deadline_in(hello_limit)).map_error([](RobotError error) {
        error.fault = RobotFault::kUnreachable;
        return error;
    });
}

RobotResult<void> GspChannel::say_hello(const GspSettings& settings, Deadline deadline) {
    if (auto sent = send(Hello{}, deadline); !sent) return sent;
    const auto reply = receive(deadline);
    if (!reply) {
        RobotError error = reply.error();
        if (error.fault == RobotFault::kTimeout) {
            error.message += "; another client may hold this port";
        }
        return tl::unexpected<RobotError>(std::move(error));
    }
    if (const auto* refusal = std::get_if<Failure>(&*reply)) {
        return tl::unexpected<RobotError>(robot_error(refusal->code, refusal->text));
    }
    const auto* hello = std::get_if<HelloReply>(&*reply);
    if (!hello) {
        return failed(
            RobotFault::kProtocol,
            fmt::format("{} answers HELLO with '{}'", lines_.connection().peer(), encode(*reply)));
    }
    auto identity = check_identity(*hello, settings.model);
    if (!identity) return tl::unexpected<RobotError>(identity.error());
    identity_ = *std::move(identity);
    return {};
}

RobotResult<void> GspChannel::send(const Request& request, Deadline deadline) {
    const auto sent = lines_.write(encode(request), deadline);
    if (!sent) return link_error(sent.error());
    return {};
}

RobotResult<Reply> GspChannel::receive(Deadline deadline) {
    const auto item = lines_.read(deadline);
    if (!item) return link_error(item.error());
    const std::string& peer = lines_.connection().peer();
    if (const auto* line = std::get_if<Line>(&*item)) {
        return decode_reply(line->text).map_error([&](RobotError error) {
            error.message = fmt::format("{} sent {}", peer, error.message);
            return error;
        });
    }
    if (const auto* broken = std::get_if<BrokenStream>(&*item)) {
        return failed(RobotFault::kProtocol, fmt::format("{} sent {}", peer, broken->why));
    }
    return failed(RobotFault::kProtocol,
                  fmt::format("{} sent a line of {} characters, {} are allowed", peer,
                              std::get<OverlongLine>(*item).length, kLongestLine));
}

RobotResult<RobotIdentity> check_identity(const HelloReply& reply, const std::string& model) {
    constexpr std::string_view kFamily = "GSP/1.";  // later minor versions add, they do not change
    if (!reply.version.starts_with(kFamily)) {
        return failed(RobotFault::kUnreachable, fmt::format("the controller speaks {}, gripscan {}",
                                                            reply.version, kVersionText));
    }
    if (reply.axes != kAxes) {
        return failed(RobotFault::kUnreachable,
                      fmt::format("the controller has {} axes, {} are needed", reply.axes, kAxes));
    }
    if (!model.empty() && reply.model != model) {
        return failed(RobotFault::kUnreachable,
                      fmt::format("the arm is a {}, a {} is expected", reply.model, model));
    }
    return RobotIdentity{reply.model, reply.axes, reply.version};
}

}  // namespace gripscan::gsp
