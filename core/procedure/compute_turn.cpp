#include "core/procedure/compute_turn.h"

#include <algorithm>
#include <atomic>

#include "core/procedure/turn_workspace.h"

namespace gripscan {
namespace {

/// Images in memory at the same time: bounds the memory on machines with many cores.
constexpr std::size_t kCapturesAtOnce = 8;

std::vector<const RecordedCapture*> used_captures(const TurnRecording& recording) {
    std::vector<const RecordedCapture*> used;
    for (const RecordedCapture& capture : recording.captures) {
        if (capture.used) used.push_back(&capture);
    }
    return used;
}

Status add_all(TurnWorkspace& workspace, const std::vector<const RecordedCapture*>& used,
               const Progress& progress, const ForEach& for_each) {
    std::atomic<std::size_t> done{0};
    progress.tell("stereo", 0, used.size());
    for (std::size_t begin = 0; begin < used.size(); begin += kCapturesAtOnce) {
        const std::size_t count = std::min(kCapturesAtOnce, used.size() - begin);
        std::vector<Result<PreparedCapture>> made;
        for (std::size_t i = 0; i < count; ++i) made.emplace_back(cancelled_error());
        for_each(count, [&](std::size_t i) {
            if (progress.cancelled()) return;
            // The captures run side by side; within one, everything runs in order.
            made[i] = workspace.prepare(*used[begin + i], progress, for_each_in_order);
            progress.tell("stereo", ++done, used.size());
        });
        // In order, so that the same capture is named whatever the threads did.
        for (auto& one : made) {
            if (!one) return forward_error(std::move(one.error()));
            workspace.insert(std::move(*one));
        }
    }
    return {};
}

}  // namespace

Result<ComputedTurn> compute_turn(const TurnRecording& recording,
                                  const ComputeTurnSettings& settings, const Progress& progress,
                                  const ForEach& for_each) {
    const auto used = used_captures(recording);
    if (used.size() < 2) {
        return input_error("a turn needs at least two used captures, there {} {}",
                           used.size() == 1 ? "is" : "are", used.size());
    }
    const bool images = std::any_of(used.begin(), used.end(), [](const RecordedCapture* capture) {
        return static_cast<bool>(capture->load_images);
    });
    auto workspace =
        TurnWorkspace::create(images ? recording.rig : std::nullopt, recording.region, settings);
    if (!workspace) return forward_error(std::move(workspace.error()));
    if (Status s = add_all(*workspace, used, progress, for_each); !s) {
        return forward_error(std::move(s.error()));
    }
    return workspace->solve(recording.captures, progress, for_each);
}

}  // namespace gripscan
