// How a long computation tells how far it is and learns that it shall stop.
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace gripscan {

/// Passed by const reference to everything that takes longer than a blink. `report` may be empty
/// and may be called from several threads; the receiver locks.
struct Progress {
    std::stop_token stop;
    std::function<void(std::string_view stage, std::size_t done, std::size_t total)> report;

    [[nodiscard]] bool cancelled() const { return stop.stop_requested(); }
    void tell(std::string_view stage, std::size_t done, std::size_t total) const {
        if (report) report(stage, done, total);
    }
};

}  // namespace gripscan
