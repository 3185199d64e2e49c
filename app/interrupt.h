// Ctrl-C as a stop token: the signal is taken by a thread of its own, so that nothing happens
// inside a signal handler. A second Ctrl-C, half a second later or more, ends the program at once.
#pragma once

#include <stop_token>
#include <thread>

namespace gripscan::app {

class Interrupt {
  public:
    /// Before any other thread starts: they all inherit that the signals are blocked.
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

  private:
    std::stop_source source_;
    std::jthread listener_;
};

}  // namespace gripscan::app
