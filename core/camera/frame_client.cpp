#include "core/camera/frame_client.h"

#include "core/camera/frame_channel.h"

namespace gripscan {

namespace {

/// The server may still be at work on a picture for someone who has gone.
TcpResult<frames::Message> greeting(frames::FrameChannel& channel,
                                    const FrameClientSettings& settings) {
    const auto until = deadline_in(settings.answer_within);
    if (settings.tell && settings.patience < settings.answer_within) {
        auto soon = channel.read(deadline_in(settings.patience));
        if (soon || soon.error().fault != TcpFault::kTimeout) return soon;
        settings.tell(
            fmt::format("waiting for the camera at {}: it takes the connection, but "
                        "does not greet; another client may hold it",
                        place_of(settings.host, settings.port)));
    }
    return channel.read(until);
}

}  // namespace

struct FrameClient::Link {
    frames::FrameChannel channel;
};

FrameClient::FrameClient(const FrameClientSettings& settings) : settings_(settings) {}
FrameClient::~FrameClient() = default;

Result<std::unique_ptr<FrameClient>> FrameClient::connect(const FrameClientSettings& settings,
                                                          const std::stop_token& stop) {
    std::unique_ptr<FrameClient> client(new FrameClient(settings));
    if (Status ok = client->open(stop); !ok) return forward_error(ok.error());
    auto description = client->ask<frames::Description>(frames::AskDescription{}, stop);
    if (!description) return forward_error(description.error());
    if (Status ok = validate(description->rig); !ok) {
        return device_error("camera at {} describes no stereo camera: {}",
                            place_of(settings.host, settings.port), ok.error().message);
    }
    client->description_ = std::move(*description);
    return client;
}

Status FrameClient::open(const std::stop_token& stop) {
    auto connection = TcpConnection::connect(settings_.host, settings_.port,
                                             deadline_in(settings_.connect_within), stop);
    if (!connection && connection.error().fault == TcpFault::kStopped) return cancelled_error();
    if (!connection) return device_error("camera: {}", connection.error().message);
    auto link = std::make_unique<Link>(Link{frames::FrameChannel(std::move(*connection))});
    const std::stop_callback on_stop(stop, [&channel = link->channel] { channel.close(); });
    const auto first = greeting(link->channel, settings_);
    if (!first && first.error().fault == TcpFault::kStopped) return cancelled_error();
    if (!first) {
        return device_error(
            "camera at {} does not greet: {}; it serves one client at a time, and another may hold "
            "it: end that one, then try again",
            place_of(settings_.host, settings_.port), first.error().message);
    }
    const auto* greeting = std::get_if<frames::Greeting>(&*first);
    if (greeting == nullptr || greeting->version != frames::kVersion) {
        return device_error("camera at {} speaks another version than {} of the frame port",
                            place_of(settings_.host, settings_.port), frames::kVersion);
    }
    link_ = std::move(link);
    return {};
}

TcpResult<frames::Message> FrameClient::exchange(const frames::Message& question,
                                                 const std::stop_token& stop) {
    const std::stop_callback on_stop(stop, [this] { link_->channel.close(); });
    if (const auto sent = link_->channel.write(question, deadline_in(settings_.connect_within));
        !sent) {
        return tl::unexpected<TcpError>(sent.error());
    }
    return link_->channel.read(deadline_in(settings_.answer_within));
}

template <typename Answer>
Result<Answer> FrameClient::ask(const frames::Message& question, const std::stop_token& stop) {
    const auto lost = [&](const std::string& why) {
        link_.reset();  // an answer that comes later must not be taken for that of another question
        return device_error("camera at {}: {}", place_of(settings_.host, settings_.port), why);
    };
    auto answer = exchange(question, stop);
    if (!answer && answer.error().fault == TcpFault::kStopped) return cancelled_error();
    if (!answer) return lost(answer.error().message);
    if (const auto* refusal = std::get_if<frames::Refusal>(&*answer)) {
        return device_error("camera at {}: {}", place_of(settings_.host, settings_.port),
                            refusal->why);
    }
    auto* wanted = std::get_if<Answer>(&*answer);
    if (wanted == nullptr) return lost("it answered something else");
    return std::move(*wanted);
}

Result<StereoFrame> FrameClient::grab(const FrameRequest& request) {
    if (!link_) {
        if (Status ok = open({}); !ok) return forward_error(ok.error());
    }
    auto frame = ask<StereoFrame>(request, {});
    if (!frame) return frame;
    const ImageSize size{frame->left.cols, frame->left.rows};
    if (size != description_.rig.image) {
        return device_error("camera at {}: a picture of {} x {} px from a camera of {} x {}",
                            place_of(settings_.host, settings_.port), size.width, size.height,
                            description_.rig.image.width, description_.rig.image.height);
    }
    return frame;
}

}  // namespace gripscan
