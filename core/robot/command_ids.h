// Ids of turns: they rise from 1 and never begin again, and a controller keeps its last one over
// power failures.
#pragma once

#include <limits>

namespace gripscan::gsp {

/// The protocol goes on to 2147483647. What lies above this is left alone, so that counting on from
/// any id in use ends in a refusal and not in an overflow.
constexpr int kGreatestId = std::numeric_limits<int>::max() - 1'000'000;

}  // namespace gripscan::gsp
