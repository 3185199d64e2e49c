#include "core/procedure/exposure.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace gripscan {
namespace {

Result<std::optional<RobotReading>> reading_of(RobotLink* robot) {
    if (robot == nullptr) return std::nullopt;
    auto reading = robot->read();
    if (!reading) return forward_error(as_error(reading.error()));
    return std::optional<RobotReading>(std::move(*reading));
}

}  // namespace

bool wait_for(double seconds, std::stop_token stop) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
    return !stop.stop_requested();
}

Result<Exposure> expose(RobotLink* robot, StereoSource& source, const Shot& shot,
                        const StillnessTest& differs, const ExposureSettings& settings,
                        std::stop_token stop) {
    if (!wait_for(settings.settle_s, stop)) return cancelled_error();
    std::string why;
    for (int i = 0; i < settings.tries; ++i) {
        if (i > 0 && !wait_for(settings.pause_s, stop)) return cancelled_error();
        auto first = source.grab({shot.index, shot.attempt, i + 1});
        if (!first) return forward_error(first.error());
        if (stop.stop_requested()) return cancelled_error();
        Exposure exposure;
        auto before = reading_of(robot);
        if (!before) return forward_error(before.error());
        // The kept one: the same images for the same capture and attempt, whatever came before.
        auto frame = source.grab({shot.index, shot.attempt, 0});
        if (!frame) return forward_error(frame.error());
        auto after = reading_of(robot);
        if (!after) return forward_error(after.error());
        if (auto moved = differs(*first, *frame)) {
            why = std::move(*moved);
            continue;
        }
        exposure.frame = std::move(*frame);
        exposure.before = std::move(*before);
        if (*after) exposure.joint6_after_rad = (*after)->joints_rad[5];
        return exposure;
    }
    return device_error(
        "the scene does not come to rest: {} ({} pairs of exposures); longer settling, or "
        "something moves in the registration area",
        why, settings.tries);
}

CaptureRecord record_of(const Shot& shot, const Exposure& exposure) {
    CaptureRecord record;
    record.index = shot.index;
    record.attempt = shot.attempt;
    record.commanded_rad = shot.commanded_rad;
    record.before = exposure.before;
    record.joint6_after_rad = exposure.joint6_after_rad;
    record.t_s = exposure.frame.t_s;
    return record;
}

}  // namespace gripscan
