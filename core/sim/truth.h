// What only the simulator knows, and the files it leaves it in.
#pragma once

#include <filesystem>

#include "core/base/for_each.h"
#include "core/sim/moment.h"
#include "core/sim/ray_scene.h"

namespace gripscan::sim {

struct TruthSource {
    const CellLayout& layout;
    const SceneModel& model;
    const Box& region;
    const Moments& captures;
};

/// T_first_k: points of what is mounted on the flange, in capture k, camera frame, into the frame
/// of the first capture.
[[nodiscard]] Pose pose_to_first(const TruthSource& truth, int capture);

/// truth.json, surface.ply (the turning solids as a mesh, camera frame of the first capture; solids
/// overlap, so it has faces inside) and visible.ply (points of that surface, at most 1 mm apart,
/// that both cameras saw inside the region in at least one capture, under less than 75° to the
/// surface's normal). Where an object is held, object_surface.ply and object_visible.ply are the
/// same of the object alone.
[[nodiscard]] Status write_truth_files(const TruthSource& truth,
                                       const std::filesystem::path& folder,
                                       const ForEach& for_each);

}  // namespace gripscan::sim
