// The simulated camera for several threads: the procedure's, and that of the frame port.
#pragma once

#include <mutex>

#include "core/sim/sim_camera.h"

namespace gripscan::sim {

/// One grab after the other. The camera must outlive it.
class GuardedSource : public StereoSource {
  public:
    explicit GuardedSource(SimCamera& camera) : camera_(camera) {}
    [[nodiscard]] Result<StereoFrame> grab(const FrameRequest& request) override {
        const std::scoped_lock lock(mutex_);
        return camera_.grab(request);
    }
    [[nodiscard]] Moments grabbed() const {
        const std::scoped_lock lock(mutex_);
        return camera_.grabbed();
    }

  private:
    mutable std::mutex mutex_;
    SimCamera& camera_;
};

}  // namespace gripscan::sim
