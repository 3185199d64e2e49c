// Clouds as files: PCD, PLY, XYZ; meshes (OBJ, STL, PLY with faces) sampled to clouds.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/result.h"
#include "core/cloud/cloud.h"

namespace gripscan {

enum class PcdEncoding { kAscii, kBinary, kCompressed };

struct CloudFileOptions {
    PcdEncoding encoding = PcdEncoding::kBinary;
    double metres_per_unit = 1.0;  ///< 0.001: the file is in millimetres
    /// Meshes are sampled with a point for every square of this side, up to a number of points:
    /// a mesh in wrong units must not fill the memory.
    double mesh_spacing_m = 0.001;
    std::size_t mesh_max_points = 500000;
    std::uint64_t mesh_seed = 1;
};

/// By extension: .pcd .ply .xyz .obj .stl. Non-finite points are removed whatever the file claims;
/// range grids keep their grid; the viewpoint is known only from a PCD. Normals, intensity, sigma
/// and seen-count are taken if they make sense for every point, else they count as unknown. The
/// message names the file, where possible the line, and what is wrong with it.
[[nodiscard]] Result<Cloud> load_cloud(const std::filesystem::path& path,
                                       const CloudFileOptions& options = {});

/// By extension: .pcd .ply .xyz (a PLY is text with kAscii, else binary). Normals, intensity,
/// seen-count and standard deviation are fields where the cloud has them. The file appears whole
/// and is read back and compared before that.
[[nodiscard]] Status save_cloud(const std::filesystem::path& path, const Cloud& cloud,
                                const CloudFileOptions& options = {});

}  // namespace gripscan
