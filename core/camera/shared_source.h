// A camera that several may ask: one exposure at a time, and whoever wants to look is shown every
// frame that anyone took.
#pragma once

#include <functional>
#include <mutex>

#include "core/camera/stereo_source.h"

namespace gripscan {

class SharedSource : public StereoSource {
  public:
    using Viewer = std::function<void(const FrameRequest&, const StereoFrame&)>;

    /// `camera` outlives it. `viewer` is called on the thread that asked, after every exposure.
    SharedSource(StereoSource& camera, Viewer viewer)
        : camera_(camera), viewer_(std::move(viewer)) {}

    /// Waits for its turn. From any thread.
    [[nodiscard]] Result<StereoFrame> grab(const FrameRequest& request) override;
    /// Only if nobody uses the camera now; nothing: somebody does.
    [[nodiscard]] std::optional<Result<StereoFrame>> try_grab(const FrameRequest& request);

  private:
    Result<StereoFrame> grab_locked(const FrameRequest& request);
    StereoSource& camera_;
    Viewer viewer_;
    std::mutex one_at_a_time_;
};

}  // namespace gripscan
