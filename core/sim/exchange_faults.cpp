#include "core/sim/exchange_faults.h"

#include <algorithm>

namespace gripscan::sim {

ExchangeFaults::ExchangeFaults(const std::vector<Fault>& faults) {
    std::copy_if(faults.begin(), faults.end(), std::back_inserter(waiting_),
                 [](const Fault& fault) { return is_of_link(fault.kind); });
}

template <typename Matches>
std::optional<Fault> ExchangeFaults::take(ExchangePoint point, const Matches& matches) {
    const auto due = std::find_if(waiting_.begin(), waiting_.end(), [&](const Fault& fault) {
        return fault.point == point && fault.step <= turns_ && matches(fault.kind);
    });
    if (due == waiting_.end()) return std::nullopt;
    const Fault fault = *due;
    waiting_.erase(due);
    return fault;
}

std::optional<Fault> ExchangeFaults::take_of_link(ExchangePoint point) {
    return take(point, [](FaultKind kind) { return !is_of_controller(kind); });
}

std::optional<Fault> ExchangeFaults::take_of_controller(ExchangePoint point) {
    return take(point, is_of_controller);
}

}  // namespace gripscan::sim
