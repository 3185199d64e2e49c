// What only the simulator knows, and the files it leaves it in.
#pragma once

#include <filesystem>
#include <map>

#include "core/base/for_each.h"
#include "core/sim/cell_layout.h"
#include "core/sim/ray_scene.h"

namespace gripscan::sim {

/// The true joints at every capture grabbed so far, by its index; a retake replaces the one before.
using TrueJoints = std::map<int, JointAngles>;

struct TruthSource {
    const CellLayout& layout;
    const SceneModel& model;
    const Box& region;
    const TrueJoints& captures;
};

/// T_first_k: points of capture k, camera frame, into the frame of the first capture.
[[nodiscard]] Pose pose_to_first(const TruthSource& truth, int capture);

/// truth.json, surface.ply (the turning solids as a mesh, camera frame of the first capture; solids
/// overlap, so it has faces inside) and visible.ply (points of that surface, at most 1 mm apart,
/// that both cameras saw inside the region in at least one capture, under less than 75° to the
/// surface's normal).
[[nodiscard]] Status write_truth_files(const TruthSource& truth,
                                       const std::filesystem::path& folder,
                                       const ForEach& for_each);

}  // namespace gripscan::sim
