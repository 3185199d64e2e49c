#include "core/robot/gsp_turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/robot/gsp_exchange.h"

namespace gripscan::gsp {
namespace {
using Clock = std::chrono::steady_clock;

class Turn {
  public:
    Turn(const TurnLinks& links, const TurnJoint6& command, std::chrono::milliseconds motion_time,
         const std::stop_token& stop)
        : links_(links),
          rules_{command, links.settings.max_recoveries},
          motion_time_(motion_time),
          stop_(stop) {}

    RobotResult<Position> run();

  private:
    RobotResult<void> send();
    TurnInput wait();
    TurnInput recover();
    bool reopen(std::chrono::milliseconds hello_limit);
    bool stands_still();

    const TurnLinks& links_;
    const TurnRules rules_;
    const std::chrono::milliseconds motion_time_;
    const std::stop_token& stop_;
    Deadline limit_{};  ///< of the state the turn is in
};

RobotResult<Position> Turn::run() {
    const GspSettings& settings = links_.settings;
    if (!links_.motion) {
        auto opened =
            GspChannel::open(settings, settings.motion_port, settings.reply_limit + motion_time_);
        if (!opened) return tl::unexpected<RobotError>(opened.error());
        links_.motion = *std::move(opened);
    }
    TurnStep now = step(TurnIdle{}, Begin{}, rules_);
    while (now.action != TurnAction::kFinish) {
        const bool was_accepted = std::holds_alternative<TurnAccepted>(now.state);
        TurnInput input = GaveUp{};
        if (now.action == TurnAction::kRecover) {
            input = recover();
        } else if (const auto sent = now.action == TurnAction::kSend ? send() : RobotResult<void>();
                   !sent) {
            input = LinkTrouble{sent.error()};
        } else {
            input = wait();
        }
        now = step(now.state, input, rules_);
        if (std::holds_alternative<TurnAccepted>(now.state) && !was_accepted) {
            limit_ = deadline_in(motion_time_ + settings.done_margin);
        }
    }
    if (const auto* done = std::get_if<TurnDone>(&now.state)) return done->position;
    RobotError error = std::get<TurnFailed>(now.state).error;
    // What follows on a connection that is out of step cannot be trusted.
    if (error.motion_unknown()) links_.motion.reset();
    return tl::unexpected<RobotError>(std::move(error));
}

RobotResult<void> Turn::send() {
    limit_ = deadline_in(links_.settings.reply_limit);
    return links_.motion->send(rules_.command, limit_);
}

TurnInput Turn::wait() {
    // Replies of other turns do not prolong it.
    if (Clock::now() >= limit_) {
        const std::string message = fmt::format("no answer to turn {} in time", rules_.command.id);
        return TimeUp{{RobotFault::kTimeout, 0, 0, message}};
    }
    auto reply = links_.motion->receive(limit_);
    if (reply) return *std::move(reply);
    if (reply.error().fault == RobotFault::kTimeout) return TimeUp{reply.error()};
    return LinkTrouble{reply.error()};
}

/// A dropped link does not stop the robot, and the controller may take a new client only after its
/// motion has ended: the search lasts longer than that.
TurnInput Turn::recover() {
    const GspSettings& settings = links_.settings;
    const auto window = settings.connect_limit + motion_time_ + settings.done_margin;
    const auto give_up = deadline_in(window);
    links_.motion.reset();
    for (;;) {
        if (links_.motion || reopen(std::max(settings.reply_limit, window / 2))) {
            if (!stop_.stop_requested()) {
                if (links_.monitor.position(1)) return LinkBack{};
            } else if (stands_still()) {
                return StandsStill{};
            }
        }
        if (Clock::now() >= give_up) return GaveUp{};
        std::this_thread::sleep_for(settings.retry_pause);
    }
}

bool Turn::reopen(std::chrono::milliseconds hello_limit) {
    auto opened = GspChannel::open(links_.settings, links_.settings.motion_port, hello_limit);
    if (!opened) return false;
    links_.motion = *std::move(opened);
    return true;
}

/// The motion task of the controller has just answered HELLO, so no older command waits for it.
bool Turn::stands_still() {
    if (!links_.monitor.stop(1)) return false;
    const auto state = links_.monitor.state(1);
    return state && state->moving == false;
}

}  // namespace

RobotResult<Position> make_turn(const TurnLinks& links, const TurnJoint6& command,
                                std::chrono::milliseconds motion_time,
                                const std::stop_token& stop) {
    return Turn(links, command, motion_time, stop).run();
}

}  // namespace gripscan::gsp
