#include "core/procedure/compute_turn.h"

#include <algorithm>

#include "core/procedure/turn_workspace.h"

namespace gripscan {
namespace {

std::vector<const RecordedCapture*> used_captures(const TurnRecording& recording) {
    std::vector<const RecordedCapture*> used;
    for (const RecordedCapture& capture : recording.captures) {
        if (capture.used) used.push_back(&capture);
    }
    return used;
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
    if (Status s = workspace->add_all(used, progress, for_each); !s) {
        return forward_error(std::move(s.error()));
    }
    return workspace->solve(recording.captures, progress, for_each);
}

}  // namespace gripscan
