#include "app/turn_driver.h"

#include "app/console.h"
#include "app/manual_prompt.h"
#include "app/turn_talk.h"

namespace gripscan::app {
namespace {
using namespace std::chrono_literals;

class Driver {
  public:
    Driver(Engine& engine, const Context& context)
        : engine_(engine), context_(context), talk_(context) {}

    /// Gives a command and waits until nothing is going on.
    Status command(const Command& command) {
        if (context_.stop.stop_requested()) return cancelled_error();
        auto reply = engine_.submit(command);
        if (!reply) return forward_error(reply.error());
        if (*reply) return input_error("{}: {}", word(command), **reply);
        return wait();
    }

    Status wait() {
        while (!at_rest()) {
            if (Status asked = ask_operator(); !asked) return asked;
            if (Status told = pass_on_stop(); !told) return told;
            auto taken = engine_.pump(50ms);
            if (!taken) return forward_error(taken.error());
            talk_.tell(engine_.state());
        }
        return {};
    }

    /// A turn that is gone on with may be asked for another speed than it began with.
    Status change_speed(const std::optional<double>& percent) {
        if (!percent || *percent == state().plan.speed_percent) return {};
        TurnPlan plan = state().plan;
        plan.speed_percent = *percent;
        auto reply = engine_.submit(command::SetPlan{plan});
        if (!reply) return forward_error(reply.error());
        if (*reply)
            return input_error("the speed stays at {} %: {}", state().plan.speed_percent, **reply);
        return {};
    }

    /// Without a robot to read, the operator says where the joint stands.
    Status ask_where_it_stands() {
        if (state().plan.mode != MotionMode::kManual || standing_joint6_rad(state())) return {};
        const auto answer = prompt_for_angle(std::nullopt, false, context_.stop);
        if (!answer) return forward_error(answer.error());
        return command(*answer);
    }

    [[nodiscard]] const ProcedureState& state() const { return engine_.state(); }
    template <typename T>
    [[nodiscard]] const T* in() const {
        return std::get_if<T>(&state().phase);
    }
    [[nodiscard]] bool stopped() const { return stopped_; }

  private:
    [[nodiscard]] bool at_rest() const {
        return in<phase::Busy>() == nullptr && in<phase::Connecting>() == nullptr &&
               in<phase::Halting>() == nullptr;
    }

    /// While a link is being connected there is nothing to stop yet: it is asked again.
    Status pass_on_stop() {
        if (stopped_ || !context_.stop.stop_requested()) return {};
        auto reply = engine_.submit(command::Stop{});
        if (!reply) return forward_error(reply.error());
        stopped_ = !*reply;
        return {};
    }

    Status ask_operator() {
        const auto* busy = in<phase::Busy>();
        if (busy == nullptr || stopped_) return {};
        const auto* waiting = std::get_if<activity::AwaitingOperator>(&busy->activity);
        if (waiting == nullptr) return {};
        const auto answer =
            prompt_for_angle(waiting->target_rad, state().reading.has_value(), context_.stop);
        if (!answer) return forward_error(answer.error());
        if (const auto* told = std::get_if<command::TellAngle>(&*answer)) {
            const double off_rad = told->joint6_rad - waiting->target_rad;
            if (std::abs(off_rad) > 0.5 * state().data.step_rad) {
                say(context_,
                    fmt::format("{:.2f} deg is {:.2f} deg from where the next view is taken, more "
                                "than half a step: turn it to {:.2f} deg, rising, or type the "
                                "angle again",
                                deg_from_rad(told->joint6_rad), deg_from_rad(std::abs(off_rad)),
                                deg_from_rad(waiting->target_rad)));
                return {};
            }
        }
        auto reply = engine_.submit(*answer);
        if (!reply) return forward_error(reply.error());
        if (*reply) say(context_, **reply);
        return {};
    }

    Engine& engine_;
    const Context& context_;
    TurnTalk talk_;
    bool stopped_ = false;
};

Status trouble_of_link(const Driver& driver) {
    const auto* offline = driver.in<phase::Offline>();
    if (offline != nullptr) return device_error("{}", offline->why);
    return {};
}

/// What stands in the way of going on, as an error; nothing: the engine rests.
Status trouble(const Driver& driver) {
    if (driver.stopped()) return cancelled_error();
    if (Status s = trouble_of_link(driver); !s) return s;
    if (const auto* interrupted = driver.in<phase::Interrupted>()) {
        return device_error("{}", interrupted->why);
    }
    return {};
}

Result<TurnEnd> end_of(Driver& driver) {
    if (Status s = trouble(driver); !s) return forward_error(s.error());
    const ProcedureState& state = driver.state();
    if (driver.in<phase::Finished>() != nullptr) {
        return state.plan.mode == MotionMode::kDry ? TurnEnd::kRehearsed : TurnEnd::kFinished;
    }
    if (state.cell && !state.cell->passed() && state.cell_note.empty()) {
        return TurnEnd::kCellRefused;
    }
    if (state.data.used().size() < 2) return TurnEnd::kNothing;
    if (Status s = driver.command(command::Finish{}); !s) return forward_error(s.error());
    if (Status s = trouble(driver); !s) return forward_error(s.error());
    return TurnEnd::kStopped;
}

}  // namespace

Result<DrivenTurn> drive_turn(Engine& engine, const DriverOptions& options,
                              const Context& context) {
    Driver driver(engine, context);
    if (Status s = driver.command(command::Connect{}); !s) return forward_error(s.error());
    if (Status s = trouble_of_link(driver); !s) return forward_error(s.error());
    if (Status s = driver.ask_where_it_stands(); !s) return forward_error(s.error());
    if (context.stop.stop_requested()) return cancelled_error();
    if (Status s = driver.change_speed(options.speed_percent); !s) return forward_error(s.error());
    if (options.resumed && driver.in<phase::Interrupted>() != nullptr) {
        auto reply = engine.submit(command::Resume{});
        if (!reply) return forward_error(reply.error());
    }
    if (!refusal(engine.state(), command::Run{})) {
        if (Status s = driver.command(command::Run{}); !s) return forward_error(s.error());
    } else if (Status s = driver.wait(); !s) {
        return forward_error(s.error());
    }
    const auto end = end_of(driver);
    if (!end) return forward_error(end.error());
    return DrivenTurn{*end, engine.state()};
}

}  // namespace gripscan::app
