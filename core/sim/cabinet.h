// The controller's cabinet: arm, controller and the faults that are due, shared by the threads of
// both links and of the camera.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "core/sim/controller.h"
#include "core/sim/exchange_faults.h"

namespace gripscan::sim {

/// Seconds of the cell's time; it does not go back.
using CellClock = std::function<double()>;

/// The steady clock, `scale` times as fast, from 0 on.
[[nodiscard]] CellClock cell_clock(double scale);

/// One answer on its way, and what happens to it.
struct Exchange {
    std::string line;                ///< empty: nothing to say, only the fault
    std::optional<Fault> disturbed;  ///< fault of the link that strikes this answer
    std::optional<Fault> afterwards; ///< one that strikes once it is out
};

/// Any thread may call.
class Cabinet {
  public:
    Cabinet(ArmMotion arm, const ControllerSettings& settings, const std::vector<Fault>& faults,
            CellClock clock);

    [[nodiscard]] Exchange answer(LinkKind link, const gsp::Request& request);
    /// What the client of the motion link is told without asking again.
    [[nodiscard]] std::optional<Exchange> outcome();
    /// Somebody has connected.
    void new_client(LinkKind link);

    [[nodiscard]] ArmState arm() const;
    /// From the next request on, as by the operator; see Controller.
    void set_conditions(const Conditions& conditions);

    /// The number of this start of the controller: a link that began in another one is gone.
    [[nodiscard]] int starts() const;
    /// It is starting again, and nobody answers.
    [[nodiscard]] bool is_away() const;

  private:
    /// Faults of the controller that are due at that point.
    void strike(ExchangePoint point, double now_s);

    mutable std::mutex mutex_;
    CellClock clock_;
    ArmMotion arm_;
    Controller controller_;
    ExchangeFaults faults_;
    int starts_ = 1;
    std::chrono::steady_clock::time_point back_at_{};
};

}  // namespace gripscan::sim
