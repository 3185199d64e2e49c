// What a controller of the tests does wrong, and when.
#pragma once

#include <algorithm>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "core/robot/gsp_error.h"

namespace gripscan::test {

/// Where in the exchange something happens.
enum class Point {
    kHello,           ///< on the motion connection: the reply to HELLO is to be sent
    kRequest,         ///< the command was read, nothing came of it yet
    kAccepted,        ///< it was taken; ACC is to be sent
    kMoving,          ///< ACC was sent, the arm is on its way
    kDone,            ///< the arm stands; DONE is to be sent
    kMonitorRequest,  ///< on the monitor: anything was read, nothing came of it yet
    kMonitorHello,    ///< on the monitor: the reply to HELLO is to be sent
    kQuestion,        ///< on the monitor: the reply to STATE or POS is to be sent
    kStop,            ///< on the monitor: the arm was stopped; OK STOP is to be sent
};

/// Trouble of the link.
enum class Mischief {
    kDrop,      ///< closes the connection
    kHalfOpen,  ///< falls silent on the connection and never closes it
    kNever,     ///< does not send it
    kLate,      ///< sends it after the client's patience
    kGarbled,   ///< sends something else
    kSplit,     ///< sends it byte by byte
    kJoined,    ///< sends it together with what follows
    kTwice,     ///< sends it twice
    kBabble,    ///< sends ends of lines without end
    kRestart,   ///< halts the arm, forgets all ids, closes everything
};

/// What a server may have got wrong for good, beyond what it hears and says (see Bends).
enum class Flaw {
    kTurnsOnMonitor,   ///< takes J6ABS there too
    kOneMonitorEver,   ///< serves no second client of the monitor
    kRepeatMoves,      ///< a repeated id turns the joint once more
    kTakesOldIds,      ///< a lower id is new
    kTakesOtherTurns,  ///< the same id with another angle or speed is new
    kNeverBusy,        ///< takes another command while the arm moves
    kDeafToStop,       ///< OK STOP, and goes on
    kNoLimits,         ///< takes any speed and target
    kForgetsOnLoss,    ///< a lost link loses its ids
    kStuckAfterLoss,   ///< refuses new turns after a link was lost on the way
    kDoneTooEarly,     ///< DONE, with the target as position, while the arm is on its way
};

/// From any thread.
class MockScript {
  public:
    void add(Point point, Mischief mischief, int times) {
        const std::lock_guard lock(mutex_);
        for (int i = 0; i < times; ++i) mischiefs_.emplace_back(point, mischief);
    }
    void add(Point point, gsp::ErrorCode code) {
        const std::lock_guard lock(mutex_);
        failures_.emplace_back(point, code);
    }
    void add(Flaw flaw) {
        const std::lock_guard lock(mutex_);
        flaws_.insert(flaw);
    }
    void clear() {
        const std::lock_guard lock(mutex_);
        mischiefs_.clear();
    }

    // What is due now; it is taken off the script.
    std::optional<Mischief> mischief_at(Point point) { return take(mischiefs_, point); }
    std::optional<gsp::ErrorCode> failure_at(Point point) { return take(failures_, point); }
    [[nodiscard]] bool has(Flaw flaw) const {
        const std::lock_guard lock(mutex_);
        return flaws_.contains(flaw);
    }

  private:
    template <typename What>
    std::optional<What> take(std::deque<std::pair<Point, What>>& lines, Point point) {
        const std::lock_guard lock(mutex_);
        const auto line = std::find_if(lines.begin(), lines.end(),
                                       [&](const auto& l) { return l.first == point; });
        if (line == lines.end()) return std::nullopt;
        const What what = line->second;
        lines.erase(line);
        return what;
    }

    mutable std::mutex mutex_;
    std::deque<std::pair<Point, Mischief>> mischiefs_;
    std::deque<std::pair<Point, gsp::ErrorCode>> failures_;
    std::set<Flaw> flaws_;
};

}  // namespace gripscan::test
