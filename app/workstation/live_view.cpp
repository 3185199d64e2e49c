#include "app/workstation/live_view.h"

#include <chrono>

#include "app/workstation/picture_facts.h"

namespace gripscan::app {
namespace {
using Clock = std::chrono::steady_clock;

double now_s() {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace

LiveView::LiveView(Rectifier rectifier, LiveViewSettings settings, std::function<void()> wake)
    : rectifier_(std::move(rectifier)), settings_(std::move(settings)), wake_(std::move(wake)) {
    shown_.on = true;
}

Result<std::unique_ptr<LiveView>> LiveView::make(const StereoRig& rig, LiveViewSettings settings,
                                                 std::function<void()> wake) {
    auto rectifier = Rectifier::create(rig);
    if (!rectifier) return forward_error(rectifier.error());
    return std::unique_ptr<LiveView>(
        new LiveView(std::move(*rectifier), std::move(settings), std::move(wake)));
}

void LiveView::show(const FrameRequest& request, const StereoFrame& frame) {
    if (request.exposure != 0) return;  // only compared with the one that is kept
    auto rectified = rectifier_.rectify(frame);
    if (!rectified) return;
    auto picture = std::make_shared<ui::StereoPicture>();
    picture->left = rectified->left.clone();
    picture->right = rectified->right.clone();
    picture->t_s = frame.t_s;
    picture->left_health = exposure_of(picture->left, rectifier_.rig(), settings_.region);
    picture->right_health = exposure_of(picture->right, rectifier_.rig(), settings_.region);
    {
        const std::lock_guard lock(mutex_);
        const double since_s = now_s() - last_shown_s_;
        last_shown_s_ += since_s;
        shown_.rate_hz = since_s > 0.0 && since_s < 2.0 ? 1.0 / since_s : 0.0;
        shown_.picture = std::move(picture);
        ++shown_.number;
        shown_.trouble.clear();
    }
    wake_();
}

void LiveView::start(SharedSource& camera) {
    thread_ = std::jthread([this, &camera](const std::stop_token& stop) { loop(camera, stop); });
}

void LiveView::set_on(bool on) {
    {
        const std::lock_guard lock(mutex_);
        shown_.on = on;
        shown_.why_off = on ? "" : "switched off";
    }
    changed_.notify_all();
}

ui::LiveStereo LiveView::shown() const {
    const std::lock_guard lock(mutex_);
    return shown_;
}

bool LiveView::wait_for_turn(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, std::chrono::duration<double>(1.0 / settings_.rate_hz),
                      [] { return false; });
    if (!shown_.on) changed_.wait(lock, stop, [&] { return shown_.on; });
    return !stop.stop_requested();
}

void LiveView::loop(SharedSource& camera, const std::stop_token& stop) {
    // Noise of a simulated camera comes from the number of the picture: below those of the warm-up.
    FrameRequest request;
    request.capture = -1000;
    while (wait_for_turn(stop)) {
        if (settings_.worth_a_look && !settings_.worth_a_look()) continue;
        --request.capture;
        const auto frame = camera.try_grab(request);
        if (!frame || *frame) continue;
        {
            const std::lock_guard lock(mutex_);
            shown_.trouble = frame->error().message;
        }
        wake_();
    }
}

}  // namespace gripscan::app
