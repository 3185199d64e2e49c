// What a turn has shown of its captures: clouds and pictures, gathered from the threads that made
// them ready and handed to the window.
#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "core/procedure/turn_workspace.h"
#include "core/stereo/rectifier.h"
#include "ui/views/snapshot.h"

namespace gripscan::app {

class SeenCaptures {
  public:
    explicit SeenCaptures(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Without a rig the captures come as clouds.
    [[nodiscard]] Status set_rig(const StereoRig& rig);

    [[nodiscard]] std::optional<RectifiedRig> rig() const;

    /// From any thread.
    void add(const RecordedCapture& capture, const PreparedCapture& prepared);
    /// In order of their indices. On the window's thread.
    [[nodiscard]] std::vector<ui::ShownCapture> all() const;
    /// Rises with every capture that came.
    [[nodiscard]] std::uint64_t generation() const;

  private:
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::shared_ptr<const Rectifier> rectifier_;
    std::map<int, ui::ShownCapture> captures_;
    std::uint64_t generation_ = 0;
};

}  // namespace gripscan::app
