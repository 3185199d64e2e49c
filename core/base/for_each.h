// A loop whose turns may run side by side. Who owns the threads decides; an algorithm only asks.
#pragma once

#include <cstddef>
#include <functional>

namespace gripscan {

/// Runs body(0) … body(n − 1), in any order and possibly at the same time, and returns when all
/// are done. Bodies write to places of their own, so that results do not depend on the order.
using ForEach = std::function<void(std::size_t n, const std::function<void(std::size_t)>& body)>;

/// The loop without threads: for tests, and for calls made from inside a parallel body.
inline void for_each_in_order(std::size_t n, const std::function<void(std::size_t)>& body) {
    for (std::size_t i = 0; i < n; ++i) body(i);
}

}  // namespace gripscan
