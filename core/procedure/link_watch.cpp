#include "core/procedure/link_watch.h"

#include <mutex>

namespace gripscan {
namespace {

/// A connection that is lost is opened again for the next beat: one beat missed is no lost link.
constexpr int kMissedBeats = 2;

}  // namespace

struct LinkWatch::Listener {
    std::mutex mutex;
    Engine* engine = nullptr;  ///< null: nobody is told any more
    Viewer viewer;
    int missed = 0;

    void take(const RobotBeat& beat) {
        const std::lock_guard lock(mutex);
        if (viewer) viewer(beat);
        missed = beat.alive ? 0 : missed + 1;
        if (missed >= kMissedBeats && engine != nullptr) {
            engine->tell(event::LinkDown{beat.trouble});
        }
    }
};

LinkWatch::LinkWatch(RobotLink& robot, Engine& engine, Viewer viewer)
    : listener_(std::make_shared<Listener>()) {
    listener_->engine = &engine;
    listener_->viewer = std::move(viewer);
    robot.on_beat([listener = listener_](const RobotBeat& beat) { listener->take(beat); });
}

LinkWatch::~LinkWatch() {
    const std::lock_guard lock(listener_->mutex);
    listener_->engine = nullptr;
    listener_->viewer = nullptr;
}

}  // namespace gripscan
