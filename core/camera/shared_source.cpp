#include "core/camera/shared_source.h"

namespace gripscan {

Result<StereoFrame> SharedSource::grab(const FrameRequest& request) {
    const std::lock_guard lock(one_at_a_time_);
    return grab_locked(request);
}

std::optional<Result<StereoFrame>> SharedSource::try_grab(const FrameRequest& request) {
    const std::unique_lock lock(one_at_a_time_, std::try_to_lock);
    if (!lock.owns_lock()) return std::nullopt;
    return grab_locked(request);
}

Result<StereoFrame> SharedSource::grab_locked(const FrameRequest& request) {
    auto frame = camera_.grab(request);
    if (frame && viewer_) viewer_(request, *frame);
    return frame;
}

}  // namespace gripscan
