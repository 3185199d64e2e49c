#include "core/camera/frame_client.h"

#include <gmock/gmock.h>

#include <thread>

#include "core/camera/frame_channel.h"
#include "core/concurrency/tcp_listener.h"

namespace gripscan {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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
std::string outcome(std::chrono::milliseconds busy, std::chrono::milliseconds answer_within,
                    std::chrono::milliseconds patience = 2s,
                    std::function<void(const std::string&)> tell = {}) {
    const BusyServer server(busy);
    FrameClientSettings settings;
    settings.port = server.port();
    settings.connect_within = 300ms;
    settings.answer_within = answer_within;
    settings.patience = patience;
    settings.tell = std::move(tell);
    const auto client = FrameClient::connect(settings);
    return client ? "connected" : client.error().message;
}

/// The error of a client that is told to stop before or while it waits for `listener`.
Error stopped(TcpListener& listener, std::chrono::milliseconds after, bool greets) {
    std::stop_source stop;
    const std::jthread operator_([&] {
        auto client = listener.accept({}, deadline_in(10s));
        if (!client) return;
        frames::FrameChannel channel(std::move(*client));
        if (greets) (void)channel.write(frames::Greeting{}, deadline_in(10s));
        std::this_thread::sleep_for(after);
        stop.request_stop();
        (void)channel.read(deadline_in(10s));  // the client goes
        (void)channel.read(deadline_in(10s));
    });
    FrameClientSettings settings;
    settings.port = listener.port();
    const auto client = FrameClient::connect(settings, stop.get_token());
    return client ? Error{ErrorKind::kRejected, "connected"} : client.error();
}

/// A program that was killed while it waited for a picture leaves the server at work on it.
TEST(FrameClient, WaitsForAServerThatIsStillBusyForSomeoneElse) {
    EXPECT_THAT(outcome(800ms, 20s), HasSubstr("the lens cap is on"));
}

TEST(FrameClient, SaysThatNobodyGreets) {
    EXPECT_THAT(outcome(600ms, 100ms),
                AllOf(HasSubstr("does not greet"), HasSubstr("another may hold it")));
}

/// Another client may hold the camera for an hour: whoever waits is told soon, and once.
TEST(FrameClient, TellsWhatItWaitsFor) {
    std::vector<std::string> told;
    const auto tell = [&](const std::string& what) { told.push_back(what); };
    EXPECT_THAT(outcome(900ms, 20s, 300ms, tell), HasSubstr("the lens cap is on"));
    EXPECT_THAT(told, ElementsAre(HasSubstr("another client may hold it")));
    told.clear();
    EXPECT_THAT(outcome(0ms, 20s, 10s, tell), HasSubstr("the lens cap is on"));
    EXPECT_THAT(told, IsEmpty()) << "it greeted in time";
}

/// It waits half a minute otherwise.
TEST(FrameClient, AStopRequestEndsTheWaiting) {
    TcpListener listener = TcpListener::open(0).value();
    for (const bool greets : {false, true}) {
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_EQ(stopped(listener, 100ms, greets).kind, ErrorKind::kCancelled) << greets;
        EXPECT_LT(std::chrono::steady_clock::now() - begin, 15s) << greets;
    }
}

}  // namespace
}  // namespace gripscan
