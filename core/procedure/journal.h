// Where the procedure writes down what it was told and what came of it, so that nothing is lost
// when the power goes.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace gripscan {

/// Named values of an entry, in order; values are text.
using JournalFields = std::vector<std::pair<std::string, std::string>>;

class Journal {
  public:
    virtual ~Journal() = default;
    /// Returns once the entry is safe. `event` is a word: "command", "capture", "result", …
    [[nodiscard]] virtual Status write(std::string_view event, const JournalFields& fields) = 0;
};

}  // namespace gripscan
