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
    int missed = 0;

    void take(const RobotBeat& beat) {
        const std::lock_guard lock(mutex);
        missed = beat.alive ? 0 : missed + 1;
        if (missed >= kMissedBeats && engine != nullptr) {
            engine->tell(event::LinkDown{beat.trouble});
        }
    }
};

LinkWatch::LinkWatch(RobotLink& robot, Engine& engine) : listener_(std::make_shared<Listener>()) {
    listener_->engine = &engine;
    robot.on_beat([listener = listener_](const RobotBeat& beat) { listener->take(beat); });
}

LinkWatch::~LinkWatch() {
    const std::lock_guard lock(listener_->mutex);
    listener_->engine = nullptr;
}

}  // namespace gripscan
