#include "core/procedure/engine.h"

#include "core/procedure/journal_codec.h"

namespace gripscan {

Engine::Engine(ProcedureState initial, EffectRunner& work, CaptureStore& store, Journal& journal)
    : state_(std::move(initial)),
      work_(work),
      store_(store),
      journal_(journal),
      worker_([this](const std::stop_token& stop) { work_loop(stop); }) {}

Engine::~Engine() {
    {
        const std::lock_guard lock(mutex_);
        next_.reset();
        current_.request_stop();
    }
    worker_.request_stop();
    worker_.join();
}

Result<std::optional<std::string>> Engine::submit(const Command& command) {
    return take(command);
}

Result<bool> Engine::pump(std::chrono::milliseconds wait) {
    if (broken_) return forward_error(*broken_);
    const auto events = received(wait);
    for (const Event& event : events) {
        // An event that makes no sense any more (a link lost while it is known to be lost) is
        // refused and does no harm.
        if (auto taken = take(event); !taken) return forward_error(taken.error());
    }
    return !events.empty();
}

Status Engine::note(std::string_view event, const JournalFields& fields) {
    if (broken_) return forward_error(*broken_);
    Status written = journal_.write(event, fields);
    if (!written) broken_ = written.error();
    return written;
}

void Engine::tell(Event event) {
    std::function<void()> wake;
    {
        const std::lock_guard lock(mutex_);
        inbox_.push_back(std::move(event));
        wake = wake_;
    }
    arrived_.notify_all();
    if (wake) wake();
}

void Engine::on_event(std::function<void()> wake) {
    const std::lock_guard lock(mutex_);
    wake_ = std::move(wake);
}

std::deque<Event> Engine::received(std::chrono::milliseconds wait) {
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, wait, [&] { return !inbox_.empty(); });
    return std::exchange(inbox_, {});
}

Result<std::optional<std::string>> Engine::take(const Input& given) {
    if (broken_) return forward_error(*broken_);
    // What is applied is what a later reading of the journal will find.
    const JournalRecord record = encode(given);
    const auto input = decode_input(record.event, record.fields);
    if (!input || !*input) {
        broken_ = input ? Error{ErrorKind::kInput, "an input that is none"} : input.error();
        return forward_error(*broken_);
    }
    Transition transition = step(state_, **input);
    if (transition.refused) return std::move(transition.refused);
    if (Status written = journal_.write(record.event, record.fields); !written) {
        broken_ = written.error();
        return forward_error(written.error());
    }
    state_ = std::move(transition.state);
    for (const Effect& effect : transition.effects) {
        if (Status done = carry_out(effect); !done) {
            broken_ = done.error();
            return forward_error(done.error());
        }
    }
    return std::nullopt;
}

Status Engine::carry_out(const Effect& effect) {
    if (std::holds_alternative<effect::SaveTable>(effect)) {
        return store_.save_table(state_.data.captures);
    }
    if (std::holds_alternative<effect::SavePlan>(effect)) return store_.save_plan(state_.plan);
    if (std::holds_alternative<effect::Halt>(effect)) {
        {
            const std::lock_guard lock(mutex_);
            current_.request_stop();
        }
        work_.halt();
        return {};
    }
    {
        const std::lock_guard lock(mutex_);
        next_ = Work{effect, state_};
        current_ = std::stop_source();
    }
    wanted_.notify_all();
    return {};
}

void Engine::work_loop(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::optional<Work> work;
        std::stop_token cancelled;
        {
            std::unique_lock lock(mutex_);
            if (!wanted_.wait(lock, stop, [&] { return next_.has_value(); })) return;
            work = std::exchange(next_, std::nullopt);
            cancelled = current_.get_token();
        }
        tell(work_.run(work->effect, work->state, cancelled));
    }
}

Result<ProcedureState> replay_inputs(const ProcedureState& initial, std::span<const Input> inputs) {
    ProcedureState state = initial;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        Transition transition = step(state, inputs[i]);
        if (transition.refused) {
            return input_error("entry {} of the journal does not follow from those before: {}",
                               i + 1, *transition.refused);
        }
        state = std::move(transition.state);
    }
    return state;
}

}  // namespace gripscan
