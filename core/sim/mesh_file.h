// Meshes and samples as binary PLY files.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/sim/mesh.h"
#include "core/sim/surface_samples.h"

namespace gripscan::sim {

/// Vertices (float, m) and triangles.
[[nodiscard]] Status save_mesh_ply(const std::filesystem::path& path, const Mesh& mesh);
/// Points with normals (float, m).
[[nodiscard]] Status save_samples_ply(const std::filesystem::path& path,
                                      const std::vector<SurfaceSample>& samples);

}  // namespace gripscan::sim
