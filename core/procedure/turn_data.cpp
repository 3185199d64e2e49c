#include "core/procedure/turn_data.h"

#include <algorithm>

namespace gripscan {

std::vector<std::size_t> TurnData::used() const {
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < captures.size(); ++i) {
        if (captures[i].status == CaptureStatus::kUsed) positions.push_back(i);
    }
    return positions;
}

const CaptureRecord* TurnData::last_used() const {
    const auto last = std::find_if(captures.rbegin(), captures.rend(), [](const auto& c) {
        return c.status == CaptureStatus::kUsed;
    });
    return last == captures.rend() ? nullptr : &*last;
}

const CaptureRecord* TurnData::find(int index) const {
    const auto found = std::find_if(captures.begin(), captures.end(),
                                    [&](const auto& c) { return c.index == index; });
    return found == captures.end() ? nullptr : &*found;
}

CaptureRecord* TurnData::find(int index) {
    return const_cast<CaptureRecord*>(std::as_const(*this).find(index));
}

int TurnData::next_index() const {
    return captures.empty() ? 0 : captures.back().index + 1;
}

}  // namespace gripscan
