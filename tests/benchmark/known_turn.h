// A recorded turn whose motion is known: its clouds, and the true motion between them.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/geometry/pose.h"

namespace gripscan::test {

struct KnownTurn {
    std::vector<Cloud> clouds;    ///< of the used captures, in order
    std::vector<Pose> T_first_k;  ///< true, one a cloud
};

/// `truth` is a folder the simulated cell wrote (--truth), or a JSON file with `axis_origin`,
/// `axis_dir` and `step_deg`, for a capture k that has turned by k steps.
[[nodiscard]] Result<KnownTurn> load_known_turn(const std::filesystem::path& session,
                                                const std::filesystem::path& truth);

}  // namespace gripscan::test
