// Points spread evenly over meshes: what an ideal scan of them would find.
#pragma once

#include <vector>

#include "core/sim/mesh.h"

namespace gripscan::sim {

struct SurfaceSample {
    Eigen::Vector3d point_m;
    Eigen::Vector3d normal;
};

/// About one sample per spacing², at least one per triangle that is larger than half of that.
[[nodiscard]] std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double spacing_m);

}  // namespace gripscan::sim
