#include "app/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>

#include "app/context.h"

namespace gripscan::app {
namespace {

using Clock = std::chrono::steady_clock;

/// What ends a program may send its signal to the process and to its group: no one means two by
/// that. Nobody presses Ctrl-C twice within this time either.
constexpr std::chrono::milliseconds kOneRequest{500};

/// SIGUSR1 wakes the listener when the program is over.
sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&set, signal);
    return set;
}

}  // namespace

Interrupt::Interrupt() {
    const sigset_t set = watched_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    listener_ = std::jthread([this, set](const std::stop_token& over) {
        Clock::time_point first{};
        while (true) {
            int signal = 0;
            if (sigwait(&set, &signal) != 0 || over.stop_requested()) return;
            if (signal == SIGUSR1) continue;
            if (!source_.stop_requested()) {
                first = Clock::now();
                source_.request_stop();
            } else if (Clock::now() - first > kOneRequest) {
                ::_exit(kCancelled);
            }
        }
    });
}

Interrupt::~Interrupt() {
    listener_.request_stop();
    pthread_kill(listener_.native_handle(), SIGUSR1);
}

}  // namespace gripscan::app
