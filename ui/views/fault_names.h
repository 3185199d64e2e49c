// The faults of the simulated cell as a list to choose from: names of docs/faults.md.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gripscan::ui {

struct FaultName {
    std::string_view name;     ///< as --fault takes it
    std::string_view meaning;  ///< what happens, with its default amount
    bool of_link = false;      ///< strikes in the exchange with the controller
};

[[nodiscard]] std::span<const FaultName> fault_names();

/// The list with one of them added or taken away; those with numbers of their own ("slip@7=1") are
/// found by their name.
[[nodiscard]] std::vector<std::string> toggled(std::vector<std::string> faults,
                                               std::string_view name);
[[nodiscard]] bool has_fault(std::span<const std::string> faults, std::string_view name);

}  // namespace gripscan::ui
