// A loop that is left early: what has not begun when it is stopped is left out.
#pragma once

#include <stop_token>
#include <utility>

#include "core/base/for_each.h"

namespace gripscan::app {

/// Bodies write to places of their own, so a result that lacks some of them is whole enough to be
/// thrown away, and good for nothing else: ask the token before using it.
[[nodiscard]] inline ForEach stoppable(ForEach loop, std::stop_token stop) {
    return [loop = std::move(loop), stop = std::move(stop)](
               std::size_t n, const std::function<void(std::size_t)>& body) {
        loop(n, [&](std::size_t i) {
            if (!stop.stop_requested()) body(i);
        });
    };
}

}  // namespace gripscan::app
