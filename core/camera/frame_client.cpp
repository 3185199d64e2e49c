#include "core/camera/frame_client.h"

#include "core/camera/frame_channel.h"

namespace gripscan {

struct FrameClient::Link {
    frames::FrameChannel channel;
};

FrameClient::FrameClient(const FrameClientSettings& settings) : settings_(settings) {}
FrameClient::~FrameClient() = default;

Result<std::unique_ptr<FrameClient>> FrameClient::connect(const FrameClientSettings& settings) {
    std::unique_ptr<FrameClient> client(new FrameClient(settings));
    if (Status ok = client->open(); !ok) return forward_error(ok.error());
    auto description = client->ask<frames::Description>(frames::AskDescription{});
    if (!description) return forward_error(description.error());
    if (Status ok = validate(description->rig); !ok) {
        return device_error("camera at {}:{} describes no stereo camera: {}", settings.host,
                            settings.port, ok.error().message);
    }
    client->description_ = std::move(*description);
    return client;
}

Status FrameClient::open() {
    auto connection = TcpConnection::connect(settings_.host, settings_.port,
                                             deadline_in(settings_.connect_within));
    if (!connection) return device_error("camera: {}", connection.error().message);
    auto link = std::make_unique<Link>(Link{frames::FrameChannel(std::move(*connection))});
    // The server may still be at work on a picture for someone who has gone.
    const auto first = link->channel.read(deadline_in(settings_.answer_within));
    if (!first) {
        return device_error("camera at {}:{} does not greet: {}", settings_.host, settings_.port,
                            first.error().message);
    }
    const auto* greeting = std::get_if<frames::Greeting>(&*first);
    if (greeting == nullptr || greeting->version != frames::kVersion) {
        return device_error("camera at {}:{} speaks another version than {} of the frame port",
                            settings_.host, settings_.port, frames::kVersion);
    }
    link_ = std::move(link);
    return {};
}

template <typename Answer>
Result<Answer> FrameClient::ask(const frames::Message& question) {
    const auto lost = [&](const std::string& why) {
        link_.reset();  // an answer that comes later must not be taken for that of another question
        return device_error("camera at {}:{}: {}", settings_.host, settings_.port, why);
    };
    if (const auto sent = link_->channel.write(question, deadline_in(settings_.connect_within));
        !sent) {
        return lost(sent.error().message);
    }
    auto answer = link_->channel.read(deadline_in(settings_.answer_within));
    if (!answer) return lost(answer.error().message);
    if (const auto* refusal = std::get_if<frames::Refusal>(&*answer)) {
        return device_error("camera at {}:{}: {}", settings_.host, settings_.port, refusal->why);
    }
    auto* wanted = std::get_if<Answer>(&*answer);
    if (wanted == nullptr) return lost("it answered something else");
    return std::move(*wanted);
}

Result<StereoFrame> FrameClient::grab(const FrameRequest& request) {
    if (!link_) {
        if (Status ok = open(); !ok) return forward_error(ok.error());
    }
    auto frame = ask<StereoFrame>(request);
    if (!frame) return frame;
    const ImageSize size{frame->left.cols, frame->left.rows};
    if (size != description_.rig.image) {
        return device_error("camera at {}:{}: a picture of {} x {} px from a camera of {} x {}",
                            settings_.host, settings_.port, size.width, size.height,
                            description_.rig.image.width, description_.rig.image.height);
    }
    return frame;
}

}  // namespace gripscan
