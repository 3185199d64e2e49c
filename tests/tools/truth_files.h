// The files in which the simulated cell leaves its truth.
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/geometry/axis.h"
#include "tests/tools/surface_distance.h"

namespace gripscan::test {

struct TrueCapture {
    Pose T_first_k = Pose::Identity();
    double joint6_deg = 0.0;
};

struct Truth {
    Axis axis;                            ///< camera frame
    std::map<int, TrueCapture> captures;  ///< by index; "first" is the lowest one
    Surface surface;                      ///< camera frame of the first capture
    Cloud visible;                        ///< the same frame
    std::optional<Surface> whole;         ///< of everything that turns, where an object alone was asked
};

/// truth.json, surface.ply and visible.ply of a folder written by SimCell::write_truth().
[[nodiscard]] Result<Truth> load_truth(const std::filesystem::path& folder);
/// The same with surface and visible places of the held object alone.
[[nodiscard]] Result<Truth> load_object_truth(const std::filesystem::path& folder);

}  // namespace gripscan::test
