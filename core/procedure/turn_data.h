// What the operator builds up, and may undo: the captures with their decisions.
#pragma once

#include <optional>
#include <vector>

#include "core/procedure/capture_record.h"

namespace gripscan {

struct TurnData {
    std::vector<CaptureRecord> captures;  ///< in order of their indices, as in captures.csv
    double step_rad = 0.0;                ///< of the next step
    bool axis_locked = false;

    [[nodiscard]] std::vector<std::size_t> used() const;  ///< positions in `captures`
    [[nodiscard]] const CaptureRecord* last_used() const;
    [[nodiscard]] CaptureRecord* find(int index);
    [[nodiscard]] const CaptureRecord* find(int index) const;
    [[nodiscard]] int next_index() const;  ///< above every index there ever was

    friend bool operator==(const TurnData&, const TurnData&) = default;
};

}  // namespace gripscan
