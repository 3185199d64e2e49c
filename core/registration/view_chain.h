// Which views belong together: the chain of trusted steps, bridged over views that the scans
// contradict.
#pragma once

#include <functional>
#include <vector>

namespace gripscan {

/// Tells whether views `from` and `to` fit together and to the robot. Asked only for views that
/// are not neighbours.
using BridgeTest = std::function<bool(std::size_t from, std::size_t to)>;

struct ViewChain {
    std::vector<std::size_t> trusted;  ///< views that fit together, rising
    std::vector<std::size_t> bridged;  ///< views left out between trusted ones: contradicted
};

/// `step_trusted[i]` says whether the step from view i to view i + 1 is trusted. Where it is not,
/// bridges over up to `longest_gap` views are tried. If the chain stays broken, the longest part
/// is taken, the earlier one where two are equal.
[[nodiscard]] ViewChain link_views(const std::vector<bool>& step_trusted, std::size_t longest_gap,
                                   const BridgeTest& bridge);

}  // namespace gripscan
