#include "core/sim/link_server.h"

#include <gtest/gtest.h>

#include "core/robot/line_channel.h"
#include "core/sim/free_ports.h"
#include "tests/unit/sim/served_cabinet.h"

namespace gripscan::sim {
namespace {

using std::chrono::milliseconds;

/// What a test waits for at most; nothing here takes a tenth of it on an idle machine.
constexpr milliseconds kPatience{10000};

/// A client as simple as a terminal.
class Terminal {
  public:
    explicit Terminal(std::uint16_t port)
        : channel_(TcpConnection::connect("127.0.0.1", port, deadline_in(kPatience)).value()) {}

    void send_bytes(std::string_view bytes) {
        ASSERT_TRUE(channel_.connection().write(bytes, deadline_in(kPatience)));
    }
    /// The next line; "closed" or "silent".
    std::string hear(milliseconds patience = kPatience) {
        const auto item = channel_.read(deadline_in(patience));
        if (!item) return item.error().fault == TcpFault::kTimeout ? "silent" : "closed";
        return std::get<Line>(*item).text;
    }
    std::string ask(std::string_view line) {
        send_bytes(std::string(line) + "\r\n");
        return hear();
    }

  private:
    LineChannel channel_;
};

bool begins(const std::string& text, std::string_view with) {
    return text.starts_with(with);
}

TEST(LinkServer, AnswersEveryRequestAndEveryMistake) {
    ServedCabinet served;
    Terminal motion(served.motion.port());
    Terminal monitor(served.monitor.port());
    EXPECT_EQ(motion.ask("HELLO 1"), "OK HELLO LRMate200iC/5L 6 GSP/1.0");
    EXPECT_EQ(monitor.ask("HELLO 1"), "OK HELLO LRMate200iC/5L 6 GSP/1.0");
    EXPECT_EQ(monitor.ask("STATE"), "OK STATE 1 1 0 0 0 100 -");
    EXPECT_TRUE(begins(monitor.ask("POS"), "OK POS "));
    EXPECT_EQ(monitor.ask("STOP"), "OK STOP");
    EXPECT_EQ(motion.ask("J6ABS 17 30.0000 50"), "OK ACC 17");
    EXPECT_TRUE(begins(motion.hear(), "DONE 17 POS "));
    const std::pair<const char*, const char*> cases[] = {{"HELLO 2", "ERR 0 102"},
                                                         {"DANCE", "ERR 0 101"},
                                                         {"J6ABS 18 abc 10", "ERR 18 100"},
                                                         {"J6ABS 18 400.0 10", "ERR 18 300"},
                                                         {"J6ABS 18 40.0 900", "ERR 18 302"},
                                                         {"J6ABS 16 30.0 10", "ERR 16 304"}};
    for (const auto& [question, answer] : cases) {
        EXPECT_TRUE(begins(motion.ask(question), answer)) << question;
    }
    EXPECT_TRUE(begins(monitor.ask("J6ABS 19 40.0 10"), "ERR 19 101"));
    served.cabinet.set_conditions({.servo_on = false});
    EXPECT_TRUE(begins(motion.ask("J6ABS 18 40.0 10"), "ERR 18 201"));
}

TEST(LinkServer, DoesNotCareForSegmentsAndLineEnds) {
    ServedCabinet served;
    Terminal terminal(served.monitor.port());
    for (const char byte : std::string("HELLO 1\r\n")) terminal.send_bytes({&byte, 1});
    EXPECT_TRUE(begins(terminal.hear(), "OK HELLO"));
    terminal.send_bytes("STATE\rPOS\nSTATE\r\n\r\nSTOP\n");
    EXPECT_TRUE(begins(terminal.hear(), "OK STATE"));
    EXPECT_TRUE(begins(terminal.hear(), "OK POS"));
    EXPECT_TRUE(begins(terminal.hear(), "OK STATE"));
    EXPECT_EQ(terminal.hear(), "OK STOP");
    EXPECT_TRUE(begins(terminal.ask(std::string(230, 'A')), "ERR 0 100"));
    EXPECT_TRUE(begins(terminal.ask("STATE"), "OK STATE")) << "the link stays";
    EXPECT_EQ(terminal.ask(std::string(300, 'A')), "closed");
}

TEST(LinkServer, ServesTheNextClientOnceTheFirstHasGone) {
    ServedCabinet served;
    auto first = std::make_unique<Terminal>(served.motion.port());
    EXPECT_EQ(first->ask("J6ABS 3 200.0 100"), "OK ACC 3");
    first.reset();  // the arm goes on
    Terminal second(served.motion.port());
    EXPECT_EQ(second.ask("J6ABS 3 200.0000 100"), "OK ACC 3");
    EXPECT_TRUE(begins(second.hear(), "DONE 3 POS"));
    EXPECT_TRUE(begins(second.ask("J6ABS 2 10.0 100"), "ERR 2 304 last=3"));
}

TEST(LinkServer, StopOnTheOtherLinkEndsTheTurn) {
    ServedCabinet served;
    Terminal motion(served.motion.port());
    Terminal monitor(served.monitor.port());
    // 300° at 1 % take 0.4 s here.
    EXPECT_EQ(motion.ask("J6ABS 1 300.0 1"), "OK ACC 1");
    EXPECT_EQ(monitor.ask("STOP"), "OK STOP");
    EXPECT_TRUE(begins(motion.hear(), "ERR 1 410"));
    EXPECT_TRUE(begins(monitor.ask("STATE"), "OK STATE 1 1 0 0 0"));
}

/// A turn that the fault strikes, and then the same id asked again on a new connection: what the
/// first client hears, and what the second.
struct Struck {
    const char* fault;
    std::vector<const char*> first;
    std::vector<const char*> second;
};

TEST(LinkServer, FaultsStrikeWhereTheyShould) {
    const Struck cases[] = {
        {"drop@1=accept", {"closed"}, {"OK ACC 1", "DONE 1"}},
        {"drop@1=run", {"OK ACC 1", "closed"}, {"OK ACC 1", "DONE 1"}},
        {"drop@1=done", {"OK ACC 1", "closed"}, {"OK ACC 1", "DONE 1"}},
        {"drop@1=after_done", {"OK ACC 1", "DONE 1", "closed"}, {"OK ACC 1", "DONE 1"}},
        {"garble@1=accept", {"PL BDD 2", "DONE 1"}, {"OK ACC 1", "DONE 1"}},
        {"garble@1=done", {"OK ACC 1", "EPOF 2"}, {"OK ACC 1", "DONE 1"}},
        {"split@1=done:0.001", {"OK ACC 1", "DONE 1"}, {"OK ACC 1", "DONE 1"}},
        {"delay@1=done:0.05", {"OK ACC 1", "DONE 1"}, {"OK ACC 1", "DONE 1"}},
        {"halfopen@1=accept", {"silent"}, {"OK ACC 1", "DONE 1"}},
        {"halfopen@1=done", {"OK ACC 1", "silent"}, {"OK ACC 1", "DONE 1"}},
        {"estop@1=accept", {"ERR 1 202"}, {"ERR 1 202"}},
        {"estop@1=run", {"OK ACC 1", "ERR 1 202"}, {"OK ACC 1", "ERR 1 202"}},
        {"servo_off@1=run", {"OK ACC 1", "ERR 1 201"}, {"OK ACC 1", "ERR 1 201"}},
        {"servo_off@1=done", {"OK ACC 1", "ERR 1 201"}, {"OK ACC 1", "ERR 1 201"}},
        {"limit@1=5", {"ERR 1 300"}, {"ERR 1 300"}},
        {"restart@1=accept:0.05", {"closed"}, {"OK ACC 1", "DONE 1"}},
        {"restart@1=run:0.05", {"OK ACC 1", "closed"}, {"OK ACC 1", "DONE 1"}},
    };
    for (const Struck& c : cases) {
        SCOPED_TRACE(c.fault);
        ServedCabinet served({c.fault});
        const auto talk = [&](const std::vector<const char*>& expected) {
            Terminal terminal(served.motion.port());
            terminal.send_bytes("J6ABS 1 60.0000 20\r\n");
            for (const std::string_view line : expected) {
                const std::string heard =
                    terminal.hear(line == "silent" ? milliseconds(100) : kPatience);
                EXPECT_TRUE(begins(heard, line)) << heard << " instead of " << line;
            }
        };
        talk(c.first);
        while (served.cabinet.is_away()) std::this_thread::sleep_for(milliseconds(5));
        std::this_thread::sleep_for(milliseconds(50));  // until the port is open again
        talk(c.second);
    }
}

TEST(LinkServer, EndsWithAClientStillConnected) {
    auto served = std::make_unique<ServedCabinet>();
    Terminal terminal(served->motion.port());
    EXPECT_EQ(terminal.ask("J6ABS 1 300.0 1"), "OK ACC 1");
    served.reset();
    EXPECT_EQ(terminal.hear(), "closed");
}

TEST(FreePorts, AreNeighboursAndATakenOneIsNamed) {
    const auto three = open_listeners(0, 3);
    ASSERT_TRUE(three);
    const auto again = open_listeners((*three)[1].port(), 1);
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().message.find(std::to_string((*three)[1].port())), std::string::npos);
    EXPECT_FALSE(open_listeners(65534, 3));
}

}  // namespace
}  // namespace gripscan::sim
