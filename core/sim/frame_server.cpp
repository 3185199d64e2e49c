#include "core/sim/frame_server.h"

#include "core/camera/frame_channel.h"
#include "core/concurrency/tcp_listener.h"

namespace gripscan::sim {
namespace {

constexpr std::chrono::milliseconds kPoll{20};
constexpr std::chrono::seconds kWrite{10};

frames::Message answer(const frames::Message& question, StereoSource& source,
                       const frames::Description& description) {
    if (std::holds_alternative<frames::AskDescription>(question)) return description;
    const auto* request = std::get_if<frames::AskFrame>(&question);
    if (request == nullptr) return frames::Refusal{"only descriptions and frames are served"};
    auto frame = source.grab(*request);
    if (!frame) return frames::Refusal{frame.error().message};
    return std::move(*frame);
}

void serve(TcpConnection connection, StereoSource& source, const frames::Description& description,
           const std::stop_token& stop) {
    frames::FrameChannel channel(std::move(connection));
    if (!channel.write(frames::Greeting{}, deadline_in(kWrite))) return;
    while (!stop.stop_requested()) {
        const auto question = channel.read(deadline_in(kPoll));
        if (!question) {
            if (question.error().fault == TcpFault::kTimeout) continue;
            return;
        }
        if (!channel.write(answer(*question, source, description), deadline_in(kWrite))) return;
    }
}

}  // namespace

FrameServer::FrameServer(TcpListener listener, StereoSource& source,
                         frames::Description description)
    : port_(listener.port()),
      thread_([&source, listener = std::move(listener), description = std::move(description)](
                  const std::stop_token& stop) mutable {
          while (!stop.stop_requested()) {
              auto client = listener.accept(stop, deadline_in(kPoll));
              if (client) serve(std::move(*client), source, description, stop);
          }
      }) {}

FrameServer::~FrameServer() = default;

}  // namespace gripscan::sim
