// The result of the cell check: each prerequisite of a turn as a number against a limit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gripscan {

enum class CheckOutcome { kPassed, kWarned, kFailed, kSkipped };
/// "passed", "warned", "failed", "skipped".
[[nodiscard]] std::string_view word(CheckOutcome outcome);

struct CellCheckItem {
    std::string name;  ///< one word: link, range, volume, …
    CheckOutcome outcome = CheckOutcome::kSkipped;
    double value = 0.0;
    double limit = 0.0;
    std::string unit;      ///< of both: deg, mm, %, s, …
    std::string sentence;  ///< what was found, and what to do where it is not right

    friend bool operator==(const CellCheckItem&, const CellCheckItem&) = default;
};

struct CellReport {
    std::vector<CellCheckItem> items;

    [[nodiscard]] bool passed() const {
        for (const auto& item : items) {
            if (item.outcome == CheckOutcome::kFailed) return false;
        }
        return true;
    }
    friend bool operator==(const CellReport&, const CellReport&) = default;
};

}  // namespace gripscan
