// Which fault of the link or the controller strikes now: each does once, when its turn has come.
#pragma once

#include <optional>
#include <vector>

#include "core/sim/fault_plan.h"

namespace gripscan::sim {

/// Strikes the controller itself rather than what it says.
[[nodiscard]] constexpr bool is_of_controller(FaultKind kind) {
    return kind >= FaultKind::kRestart && kind <= FaultKind::kLimit;
}

/// Not for several threads at once.
class ExchangeFaults {
  public:
    ExchangeFaults() = default;
    /// Takes those of link and controller out of all.
    explicit ExchangeFaults(const std::vector<Fault>& faults);

    /// One more J6ABS has come.
    void count_turn() { ++turns_; }

    [[nodiscard]] std::optional<Fault> take_of_link(ExchangePoint point);
    [[nodiscard]] std::optional<Fault> take_of_controller(ExchangePoint point);

  private:
    template <typename Matches>
    std::optional<Fault> take(ExchangePoint point, const Matches& matches);

    std::vector<Fault> waiting_;
    int turns_ = 0;
};

}  // namespace gripscan::sim
