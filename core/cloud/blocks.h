// Points handed out to threads in blocks: a turn of a loop must be worth its call.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/for_each.h"

namespace gripscan {

/// Runs body(begin, end) for consecutive ranges that cover 0 … n − 1.
template <typename Body>
void for_each_block(std::size_t n, const ForEach& for_each, Body body) {
    constexpr std::size_t kBlock = 512;
    for_each((n + kBlock - 1) / kBlock,
             [&](std::size_t block) { body(block * kBlock, std::min((block + 1) * kBlock, n)); });
}

}  // namespace gripscan
