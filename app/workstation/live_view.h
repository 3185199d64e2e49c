// Live images while nothing else uses the camera: a thread that takes pictures at a modest rate and
// keeps the latest. Pictures that captures take are shown too.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "core/camera/shared_source.h"
#include "core/stereo/rectifier.h"
#include "ui/views/snapshot.h"

namespace gripscan::app {

struct LiveViewSettings {
    double rate_hz = 5.0;
    std::optional<Box> region;  ///< where exposure is measured
    /// Says whether another picture could differ from the last; empty: always. A simulated camera
    /// need not take the same picture again and again.
    std::function<bool()> worth_a_look;
};

class LiveView {
  public:
    /// `camera` outlives it; `wake` is called from its threads. Errors: a rig that makes no sense.
    [[nodiscard]] static Result<std::unique_ptr<LiveView>> make(const StereoRig& rig,
                                                                LiveViewSettings settings,
                                                                std::function<void()> wake);
    ~LiveView() = default;
    LiveView(const LiveView&) = delete;
    LiveView& operator=(const LiveView&) = delete;

    /// A frame that anybody took; from any thread.
    void show(const FrameRequest& request, const StereoFrame& frame);
    void start(SharedSource& camera);
    /// Takes no further picture of its own; returns once that is so.
    void stop() { thread_ = {}; }
    void set_on(bool on);
    [[nodiscard]] ui::LiveStereo shown() const;

  private:
    LiveView(Rectifier rectifier, LiveViewSettings settings, std::function<void()> wake);
    void loop(SharedSource& camera, const std::stop_token& stop);
    bool wait_for_turn(const std::stop_token& stop);

    Rectifier rectifier_;
    LiveViewSettings settings_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    ui::LiveStereo shown_;
    double last_shown_s_ = 0.0;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace gripscan::app
