#include "app/workstation/live_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/workstation/pair_measure.h"
#include "app/workstation/picture_facts.h"
#include "core/concurrency/thread_priority.h"

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
    if (!rectified) {
        const std::lock_guard lock(mutex_);
        shown_.trouble = rectified.error().message;
        ++shown_.lost.not_shown;
        return;
    }
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
        if (shown_.picture && seen_ != shown_.number) ++shown_.lost.not_shown;
        shown_.picture = std::move(picture);
        ++shown_.number;
        shown_.trouble.clear();
    }
    changed_.notify_all();
    wake_();
}

void LiveView::start(SharedSource& camera) {
    matcher_ = std::jthread([this](const std::stop_token& stop) { match_loop(stop); });
    thread_ = std::jthread([this, &camera](const std::stop_token& stop) { loop(camera, stop); });
}

void LiveView::stop() {
    thread_ = {};
    matcher_ = {};
}

void LiveView::set_on(bool on) {
    {
        const std::lock_guard lock(mutex_);
        shown_.on = on;
        shown_.why_off = on ? "" : "switched off";
    }
    changed_.notify_all();
}

void LiveView::set_quiet(const std::string& why) {
    {
        const std::lock_guard lock(mutex_);
        if (shown_.why_not_matched == why) return;
        shown_.why_not_matched = why;
        if (!why.empty()) matching_.request_stop();
    }
    changed_.notify_all();
}

ui::LiveStereo LiveView::shown() const {
    const std::lock_guard lock(mutex_);
    seen_ = shown_.number;
    return shown_;
}

bool LiveView::wait_for_turn(const std::stop_token& stop) {
    const double period_s = 1.0 / settings_.rate_hz;
    std::unique_lock lock(mutex_);
    due_s_ += period_s;
    const double wait_s = std::clamp(due_s_ - now_s(), 0.0, period_s);
    (void)changed_.wait_for(lock, stop, std::chrono::duration<double>(wait_s),
                            [&] { return stop.stop_requested(); });
    if (!shown_.on) {
        (void)changed_.wait(lock, stop, [&] { return shown_.on; });
        due_s_ = now_s();
    }
    return !stop.stop_requested();
}

/// What was due since the picture before was asked for.
void LiveView::note_late() {
    const double missed = std::floor((now_s() - due_s_) * settings_.rate_hz);
    if (missed < 1.0) return;
    due_s_ += missed / settings_.rate_hz;
    const std::lock_guard lock(mutex_);
    shown_.lost.late += static_cast<std::uint64_t>(missed);
}

void LiveView::loop(SharedSource& camera, const std::stop_token& stop) {
    // Noise of a simulated camera comes from the number of the picture: below those of the warm-up.
    FrameRequest request;
    request.capture = -1000;
    due_s_ = now_s();
    while (wait_for_turn(stop)) {
        if (settings_.worth_a_look && !settings_.worth_a_look()) {
            due_s_ = now_s();
            continue;
        }
        --request.capture;
        const auto frame = camera.try_grab(request);
        if (!frame || settings_.worth_a_look) {
            due_s_ = now_s();  // somebody else has the camera, or it cannot be late
        } else {
            note_late();
        }
        if (!frame || *frame) continue;
        {
            const std::lock_guard lock(mutex_);
            shown_.trouble = frame->error().message;
            ++shown_.lost.not_delivered;
        }
        wake_();
    }
}

std::shared_ptr<const ui::StereoPicture> LiveView::wait_for_pair(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    const bool there = changed_.wait(lock, stop, [&] {
        return shown_.on && shown_.why_not_matched.empty() && shown_.picture &&
               looked_at_ != shown_.number;
    });
    if (!there) return nullptr;
    looked_at_ = shown_.number;
    matching_ = std::stop_source();
    return shown_.picture;
}

void LiveView::match_loop(const std::stop_token& stop) {
    work_in_background();
    const std::stop_callback give_up(stop, [this] {
        const std::lock_guard lock(mutex_);
        matching_.request_stop();
    });
    while (const auto pair = wait_for_pair(stop)) {
        const double begun_s = now_s();
        std::stop_token given_up;
        {
            const std::lock_guard lock(mutex_);
            if (stop.stop_requested()) return;
            given_up = matching_.get_token();
        }
        auto measured = measure_pair(*pair, rectifier_.rig(), settings_.region, given_up);
        std::unique_lock lock(mutex_);
        if (measured) {
            shown_.matched = std::move(measured->picture);
            shown_.matched_facts = std::move(measured->facts);
            lock.unlock();
            wake_();
            lock.lock();
        } else {
            looked_at_ = 0;  // it was given up: it may be matched later
        }
        const double took_s = now_s() - begun_s;
        const double rest_s = std::max(settings_.matched_every_s - took_s,
                                       took_s * (1.0 / settings_.matching_share - 1.0));
        (void)changed_.wait_for(lock, stop, std::chrono::duration<double>(rest_s),
                                [&] { return stop.stop_requested(); });
    }
}

}  // namespace gripscan::app
