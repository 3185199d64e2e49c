// The files in which the simulated cell leaves its truth.
#pragma once

#include <filesystem>
#include <map>

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
};

/// truth.json, surface.ply and visible.ply of a folder written by SimCell::write_truth().
[[nodiscard]] Result<Truth> load_truth(const std::filesystem::path& folder);

}  // namespace gripscan::test
