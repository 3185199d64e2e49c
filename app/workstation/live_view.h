// Live images while nothing else uses the camera: a thread that takes pictures at a modest rate and
// keeps the latest. Pictures that captures take are shown too. A second thread matches one pair now
// and then, while nothing else computes, and tells what only a matched pair can.
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
    /// need not take the same picture again and again, and takes as long as it computes: it is
    /// never late.
    std::function<bool()> worth_a_look;
    double matched_every_s = 0.7;  ///< at most so often a pair is matched …
    double matching_share = 0.25;  ///< … and in at most so much of the time, on one core
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
    /// Takes and matches no further picture of its own; returns once that is so.
    void stop();
    void set_on(bool on);
    /// Why no pair is to be matched now; empty: it may. One that is being matched is given up.
    void set_quiet(const std::string& why);
    /// For the window: whoever asks has seen the latest picture.
    [[nodiscard]] ui::LiveStereo shown() const;

  private:
    LiveView(Rectifier rectifier, LiveViewSettings settings, std::function<void()> wake);
    void loop(SharedSource& camera, const std::stop_token& stop);
    bool wait_for_turn(const std::stop_token& stop);
    void note_late();
    void match_loop(const std::stop_token& stop);
    /// The next pair to match; null: stopped.
    std::shared_ptr<const ui::StereoPicture> wait_for_pair(const std::stop_token& stop);

    Rectifier rectifier_;
    LiveViewSettings settings_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    ui::LiveStereo shown_;
    mutable std::uint64_t seen_ = 0;  ///< number of the picture that the window has
    std::uint64_t looked_at_ = 0;     ///< number of the pair that was matched or given up
    std::stop_source matching_;       ///< of the pair that is being matched
    double last_shown_s_ = 0.0;
    double due_s_ = 0.0;  ///< when the next picture is; of the first thread alone
    std::jthread matcher_;
    std::jthread thread_;  // last: they use all of the above
};

}  // namespace gripscan::app
