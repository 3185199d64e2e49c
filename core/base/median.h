// The middle of some values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gripscan {

/// Of an even number the upper of the two in the middle. There has to be one value at least.
template <typename T>
[[nodiscard]] T median_of(std::vector<T> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace gripscan
