// A client of the tests' controller, as its server sees it: lines in, lines out, each bent as a
// broken server would.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/concurrency/tcp_connection.h"
#include "core/robot/line_framer.h"

namespace gripscan::test {

enum class Side { kMotion, kMonitor };

/// Turns what is heard or said into something else.
using Bend = std::function<std::string(std::string)>;

struct Bends {
    Bend heard;  ///< of the bytes of one segment
    Bend said;   ///< of one line without its end; an empty one is not sent
};

class MockClient {
  public:
    MockClient(TcpConnection connection, Bends bends)
        : connection_(std::move(connection)), bends_(std::move(bends)) {}

    /// What comes within the tick; a connection that has ended makes it gone.
    std::optional<FramedItem> read(std::chrono::milliseconds tick) {
        if (auto item = framer_.next()) return item;
        const auto bytes = connection_.read_some(deadline_in(tick));
        if (!bytes) {
            gone_ = gone_ || bytes.error().fault != TcpFault::kTimeout;
            return std::nullopt;
        }
        framer_.feed(bends_.heard ? bends_.heard(*bytes) : *bytes);
        return framer_.next();
    }

    /// The line as it goes out, with its end.
    [[nodiscard]] std::string bytes_of(const std::string& line) const {
        std::string said = bends_.said ? bends_.said(line) : line;
        return said.empty() ? said : said.append(kLineEnd);
    }
    /// Also what was held back before.
    void send(const std::string& bytes) {
        if (gone_) return;
        const auto sent = connection_.write(std::exchange(held_back_, {}) + bytes,
                                            deadline_in(std::chrono::seconds(5)));
        gone_ = !sent;
    }
    void hold_back(const std::string& bytes) { held_back_ += bytes; }

    void close() {
        connection_.close();
        gone_ = true;
    }
    /// The connection stays open, and nobody serves it any more.
    TcpConnection abandon() {
        gone_ = true;
        return std::move(connection_);
    }
    [[nodiscard]] bool gone() const { return gone_; }

  private:
    TcpConnection connection_;
    Bends bends_;
    LineFramer framer_;
    std::string held_back_;
    bool gone_ = false;
};

}  // namespace gripscan::test
