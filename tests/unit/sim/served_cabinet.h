// The simulated controller on the loopback, without the rest of its cell.
#pragma once

#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/concurrency/tcp_listener.h"
#include "core/sim/free_ports.h"
#include "core/sim/link_server.h"

namespace gripscan::sim {

/// Controller and arm behind two real ports, faster than in life.
class ServedCabinet {
  public:
    explicit ServedCabinet(const std::vector<std::string>& faults = {}, double time_scale = 100.0)
        : cabinet(ArmMotion({0, 0, 0, 0, rad_from_deg(-90), 0}, 3), {},
                  parse_faults(faults).value(), cell_clock(time_scale)),
          ports_(open_listeners(0, 2).value()),
          motion(std::move(ports_[0]), LinkKind::kMotion, cabinet),
          monitor(std::move(ports_[1]), LinkKind::kMonitor, cabinet) {}

    Cabinet cabinet;

  private:
    std::vector<TcpListener> ports_;

  public:
    LinkServer motion;
    LinkServer monitor;
};

}  // namespace gripscan::sim
