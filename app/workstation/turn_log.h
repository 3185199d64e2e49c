// What the window's log tells of a turn: each thing that happened once, with a code.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/procedure/procedure_state.h"
#include "ui/views/snapshot.h"

namespace gripscan::app {

/// Compares the state with what was told before. Codes: LNK link, CEL cell check, AXS axis, CAP
/// captures, REG registration, ADV advice, RUN procedure, MRG template.
class TurnLog {
  public:
    /// What is new, in order.
    [[nodiscard]] std::vector<ui::LogLine> news(const ProcedureState& state);

  private:
    void say(ui::LogLevel level, std::string_view code, std::string text);
    void tell_phase(const ProcedureState& state);
    void tell_cell(const ProcedureState& state);
    void tell_captures(const ProcedureState& state);
    void tell_steps(const ProcedureState& state);

    std::vector<ui::LogLine> news_;
    bool robot_told_ = false;
    bool axis_told_ = false;
    std::size_t advice_told_ = 0;
    std::size_t rehearsed_told_ = 0;
    std::string trouble_told_;
    bool solved_told_ = false;
    std::map<std::string, std::string> items_told_;
    std::set<std::pair<int, int>> captures_told_;            ///< index, attempt
    std::map<std::pair<int, int>, std::string> steps_told_;  ///< the sentence of each
};

}  // namespace gripscan::app
