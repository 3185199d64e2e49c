// Clouds as files: PCD, PLY, XYZ; meshes (OBJ, STL, PLY with faces) sampled to clouds.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/cloud/cloud.h"

namespace gripscan {

enum class PcdEncoding { kAscii, kBinary, kCompressed };

struct CloudFileOptions {
    PcdEncoding encoding = PcdEncoding::kBinary;
    double metres_per_unit = 1.0;  ///< 0.001: the file is in millimetres
};

/// By extension: .pcd .ply .xyz .obj .stl. Non-finite points are removed whatever the file claims;
/// range grids keep their grid. The message names the file and what is wrong with it.
[[nodiscard]] Result<Cloud> load_cloud(const std::filesystem::path& path,
                                       const CloudFileOptions& options = {});

/// By extension: .pcd .ply .xyz. Normals, intensity, seen-count and standard deviation are fields
/// where the cloud has them. The file appears whole and is read back and compared before that.
[[nodiscard]] Status save_cloud(const std::filesystem::path& path, const Cloud& cloud,
                                const CloudFileOptions& options = {});

}  // namespace gripscan
