#include "core/registration/view_chain.h"

#include <algorithm>

namespace gripscan {
namespace {

/// A part of the turn in which everything fits together.
using Part = std::vector<std::size_t>;

}  // namespace

ViewChain link_views(const std::vector<bool>& step_trusted, std::size_t longest_gap,
                     const BridgeTest& bridge) {
    const std::size_t views = step_trusted.size() + 1;
    std::vector<Part> parts{{0}};
    for (std::size_t i = 0; i + 1 < views;) {
        if (step_trusted[i]) {
            parts.back().push_back(++i);
            continue;
        }
        // The nearest later view that fits again; those between are contradicted.
        std::size_t next = i + 1;
        for (std::size_t to = i + 2; to < views && to <= i + 1 + longest_gap; ++to) {
            if (bridge(i, to)) {
                next = to;
                break;
            }
        }
        if (next == i + 1) parts.emplace_back();
        parts.back().push_back(next);
        i = next;
    }
    const auto longest =
        std::max_element(parts.begin(), parts.end(),
                         [](const Part& a, const Part& b) { return a.size() < b.size(); });
    ViewChain chain;
    chain.trusted = *longest;
    for (std::size_t k = 1; k < chain.trusted.size(); ++k) {
        for (std::size_t v = chain.trusted[k - 1] + 1; v < chain.trusted[k]; ++v) {
            chain.bridged.push_back(v);
        }
    }
    return chain;
}

}  // namespace gripscan
