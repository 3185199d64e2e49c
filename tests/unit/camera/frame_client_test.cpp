#include "core/camera/frame_client.h"

#include <gmock/gmock.h>

#include <thread>

#include "core/camera/frame_channel.h"
#include "core/concurrency/tcp_listener.h"

namespace gripscan {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// Greets its one client late, and answers whatever it asks with a refusal.
class BusyServer {
  public:
    explicit BusyServer(std::chrono::milliseconds busy)
        : listener_(TcpListener::open(0).value()),
          thread_([this, busy](const std::stop_token& stop) {
              auto client = listener_.accept(stop, deadline_in(10s));
              if (!client) return;
              frames::FrameChannel channel(std::move(*client));
              std::this_thread::sleep_for(busy);
              if (!channel.write(frames::Greeting{}, deadline_in(10s))) return;
              if (!channel.read(deadline_in(10s))) return;
              (void)channel.write(frames::Refusal{"the lens cap is on"}, deadline_in(10s));
          }) {}
    [[nodiscard]] std::uint16_t port() const { return listener_.port(); }

  private:
    TcpListener listener_;
    std::jthread thread_;  // last: it uses the listener
};

/// What came of connecting; never a camera, as the server refuses to describe one.
std::string outcome(std::chrono::milliseconds busy, std::chrono::milliseconds answer_within) {
    const BusyServer server(busy);
    FrameClientSettings settings;
    settings.port = server.port();
    settings.connect_within = 300ms;
    settings.answer_within = answer_within;
    const auto client = FrameClient::connect(settings);
    return client ? "connected" : client.error().message;
}

/// A program that was killed while it waited for a picture leaves the server at work on it.
TEST(FrameClient, WaitsForAServerThatIsStillBusyForSomeoneElse) {
    EXPECT_THAT(outcome(800ms, 20s), HasSubstr("the lens cap is on"));
}

TEST(FrameClient, SaysThatNobodyGreets) {
    EXPECT_THAT(outcome(600ms, 100ms), HasSubstr("does not greet"));
}

}  // namespace
}  // namespace gripscan
