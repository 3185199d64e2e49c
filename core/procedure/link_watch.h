// Tells an engine that its robot does not answer any more, also while nothing is asked of it.
#pragma once

#include <functional>
#include <memory>

#include "core/procedure/engine.h"
#include "core/robot/robot_link.h"

namespace gripscan {

/// From its construction, which has to come before the link is opened, to its destruction, which
/// has to come before the engine's. What the engine knows already it refuses.
class LinkWatch {
  public:
    using Viewer = std::function<void(const RobotBeat&)>;
    /// `viewer`, which may be empty, is shown every beat, from a thread of the link.
    LinkWatch(RobotLink& robot, Engine& engine, Viewer viewer = {});
    ~LinkWatch();
    LinkWatch(const LinkWatch&) = delete;
    LinkWatch& operator=(const LinkWatch&) = delete;

  private:
    struct Listener;
    std::shared_ptr<Listener> listener_;  ///< shared with the link, which may outlive the engine
};

}  // namespace gripscan
