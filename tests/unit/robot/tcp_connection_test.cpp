// Over the loopback, on free ports. Long deadlines are there so that a hang fails and a slow
// machine does not; nothing here measures time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "core/concurrency/tcp_listener.h"
#include "core/robot/line_channel.h"

namespace gripscan {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

Deadline soon() {
    return deadline_in(milliseconds(30));
}
Deadline late() {
    return deadline_in(std::chrono::seconds(20));
}

struct Pair {
    TcpListener listener = TcpListener::open(0).value();
    TcpConnection client = TcpConnection::connect("127.0.0.1", listener.port(), late()).value();
    TcpConnection server = listener.accept({}, late()).value();
};

TEST(TcpConnection, CarriesBytesBothWays) {
    Pair pair;
    ASSERT_TRUE(pair.client.write("ping", late()));
    EXPECT_EQ(pair.server.read_some(late()), "ping");
    ASSERT_TRUE(pair.server.write("pong", late()));
    EXPECT_EQ(pair.client.read_some(late()), "pong");
    EXPECT_EQ(pair.client.peer(), "127.0.0.1:" + std::to_string(pair.listener.port()));
}

TEST(TcpConnection, AnAddressWithColonsStandsInBrackets) {
    EXPECT_EQ(place_of("robot.local", 18740), "robot.local:18740");
    EXPECT_EQ(place_of("::1", 18740), "[::1]:18740");
}

TEST(TcpConnection, CarriesMoreThanTheSystemBuffers) {
    Pair pair;
    const std::string sent(8'000'000, 'x');
    std::size_t received = 0;
    std::jthread reader([&] {
        while (received < sent.size()) {
            const auto bytes = pair.server.read_some(late());
            if (!bytes) return;
            received += bytes->size();
        }
    });
    EXPECT_TRUE(pair.client.write(sent, late()));
    reader.join();
    EXPECT_EQ(received, sent.size());
}

TEST(TcpConnection, ReadAndWriteEndAtTheirDeadlines) {
    Pair pair;
    EXPECT_EQ(pair.client.read_some(soon()).error().fault, TcpFault::kTimeout);
    const std::string much(16'000'000, 'x');  // nobody reads it
    EXPECT_EQ(pair.client.write(much, soon()).error().fault, TcpFault::kTimeout);
}

TEST(TcpConnection, NoticesThatTheOtherSideIsGone) {
    Pair pair;
    { const TcpConnection gone = std::move(pair.server); }
    const auto read = pair.client.read_some(late());
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().fault, TcpFault::kClosed);
    EXPECT_THAT(read.error().message, HasSubstr("closed the connection"));
}

TEST(TcpConnection, CloseFromAnotherThreadEndsAWaitingRead) {
    Pair pair;
    std::jthread closer([&] {
        std::this_thread::sleep_for(milliseconds(20));
        pair.client.close();
    });
    EXPECT_EQ(pair.client.read_some(late()).error().fault, TcpFault::kStopped);
    EXPECT_EQ(pair.client.write("x", late()).error().fault, TcpFault::kStopped);
    EXPECT_EQ(pair.server.read_some(late()).error().fault, TcpFault::kClosed);
}

TEST(TcpConnection, ClosedByBothSidesAtOnceIsNoTrouble) {
    Pair pair;
    pair.server.close();
    pair.client.close();
    EXPECT_EQ(pair.client.read_some(late()).error().fault, TcpFault::kStopped);
}

TEST(TcpConnection, SaysWhyItCannotConnect) {
    std::uint16_t port = 0;
    { port = TcpListener::open(0).value().port(); }
    const auto refused = TcpConnection::connect("localhost", port, late());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, TcpFault::kRefused);
    EXPECT_THAT(refused.error().message, HasSubstr("localhost:" + std::to_string(port)));

    const auto unknown = TcpConnection::connect("no.such.host.invalid", 1, late());
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().fault, TcpFault::kAddress);
    EXPECT_THAT(unknown.error().message, HasSubstr("no.such.host.invalid"));
}

TEST(TcpConnection, AStopRequestEndsConnecting) {
    std::stop_source stop;
    stop.request_stop();
    // An address reserved for documentation: whoever routes it, nobody answers at once.
    const auto stopped = TcpConnection::connect("192.0.2.1", 9, late(), stop.get_token());
    ASSERT_FALSE(stopped);
    EXPECT_THAT(stopped.error().fault, testing::AnyOf(TcpFault::kStopped, TcpFault::kFailed));
}

TEST(TcpListener, StopsWaitingWhenAskedAndWaitsAgain) {
    auto listener = TcpListener::open(0).value();
    EXPECT_EQ(listener.accept({}, soon()).error().fault, TcpFault::kTimeout);
    std::stop_source stop;
    std::jthread stopper([&] {
        std::this_thread::sleep_for(milliseconds(20));
        stop.request_stop();
    });
    EXPECT_EQ(listener.accept(stop.get_token()).error().fault, TcpFault::kStopped);
    const auto client = TcpConnection::connect("127.0.0.1", listener.port(), late());
    ASSERT_TRUE(client);
    EXPECT_TRUE(listener.accept({}, late()));
    listener.close();
    EXPECT_EQ(listener.accept({}).error().fault, TcpFault::kStopped);
}

TEST(TcpListener, SaysThatThePortIsTaken) {
    const auto listener = TcpListener::open(0).value();
    const auto second = TcpListener::open(listener.port());
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().fault, TcpFault::kRefused);
    EXPECT_THAT(second.error().message, HasSubstr("another program has the port"));
    EXPECT_EQ(TcpListener::open(0, "here").error().fault, TcpFault::kAddress);
    EXPECT_EQ(TcpListener::open(0, "192.0.2.1").error().fault, TcpFault::kAddress);
}

TEST(LineChannel, SpeaksInLinesWhateverTheSegments) {
    Pair pair;
    LineChannel channel(std::move(pair.server));
    for (const char* part : {"HEL", "LO 1\r", "\nPOS\r\nST", "OP\n"}) {
        ASSERT_TRUE(pair.client.write(part, late()));
    }
    for (const char* line : {"HELLO 1", "POS", "STOP"}) {
        EXPECT_EQ(std::get<Line>(*channel.read(late())).text, line);
    }
    ASSERT_TRUE(channel.write("OK STOP", late()));
    EXPECT_EQ(pair.client.read_some(late()), "OK STOP\r\n");
}

}  // namespace
}  // namespace gripscan
