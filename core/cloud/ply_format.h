// The Stanford polygon format (PLY): clouds, range grids and triangle meshes, as text and in
// either byte order. Decoding trusts nothing in the file.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/cloud/point_table.h"
#include "core/cloud/triangle_mesh.h"

namespace gripscan {

struct PlyContent {
    /// The vertices; with a range grid its cells.
    PointTable points;
    /// Not empty if the file has faces: then it is a surface and `points` are its corners.
    std::vector<Triangle> triangles;
};

/// The message says what is wrong and where; the caller adds the file.
[[nodiscard]] Result<PlyContent> decode_ply(std::string_view bytes);

enum class PlyEncoding { kAscii, kBinary };

/// A grid is written as Stanford's element range_grid. PLY has no place for a viewpoint.
[[nodiscard]] std::string encode_ply(const PointTable& table, PlyEncoding encoding);

}  // namespace gripscan
