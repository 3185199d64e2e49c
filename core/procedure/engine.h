// The procedure as it runs: takes commands, lets the worker do what step() wants done, and writes
// every input to the journal before it takes effect.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/base/result.h"
#include "core/procedure/capture_store.h"
#include "core/procedure/effect_runner.h"
#include "core/procedure/journal.h"
#include "core/procedure/step.h"

namespace gripscan {

/// Belongs to one thread, the owner's: only tell() may be called from others. An error of submit()
/// or pump() means that journal or disk could not be written: nothing more is taken then, and what
/// lies on the disk is the state before.
class Engine {
  public:
    Engine(ProcedureState initial, EffectRunner& work, CaptureStore& store, Journal& journal);
    /// Stops what is going on and waits for it; that end is not journalled.
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    [[nodiscard]] const ProcedureState& state() const { return state_; }

    /// Why the command was refused; nothing: it was taken.
    [[nodiscard]] Result<std::optional<std::string>> submit(const Command& command);
    /// Takes the events that have come, waiting for the first one no longer than this. False: none
    /// came.
    [[nodiscard]] Result<bool> pump(std::chrono::milliseconds wait);
    /// Writes down what was done beside the procedure; `event` is neither "command" nor "event".
    [[nodiscard]] Status note(std::string_view event, const JournalFields& fields);
    /// An event from outside, such as a lost link.
    void tell(Event event);
    /// Called, from any thread, whenever an event has come and pump() has something to do.
    void on_event(std::function<void()> wake);

  private:
    struct Work {
        Effect effect;
        ProcedureState state;
    };
    [[nodiscard]] Result<std::optional<std::string>> take(const Input& given);
    [[nodiscard]] Status carry_out(const Effect& effect);
    void work_loop(const std::stop_token& stop);
    [[nodiscard]] std::deque<Event> received(std::chrono::milliseconds wait);

    ProcedureState state_;
    EffectRunner& work_;
    CaptureStore& store_;
    Journal& journal_;
    std::optional<Error> broken_;

    std::mutex mutex_;
    std::condition_variable_any wanted_;
    std::condition_variable arrived_;
    std::optional<Work> next_;
    std::stop_source current_;  ///< of the effect that is running
    std::deque<Event> inbox_;
    std::function<void()> wake_;
    std::jthread worker_;  // last: it uses all of the above
};

/// The state that a journal's inputs lead to, and what of them could not be taken (a journal of
/// another program).
[[nodiscard]] Result<ProcedureState> replay_inputs(const ProcedureState& initial,
                                                   std::span<const Input> inputs);

}  // namespace gripscan
