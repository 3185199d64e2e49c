// A surface of triangles, and points sampled from it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/cloud.h"

namespace gripscan {

using Triangle = std::array<std::uint32_t, 3>;  ///< corners, counter-clockwise from outside

struct TriangleMesh {
    std::vector<Eigen::Vector3d> vertices;  ///< m
    std::vector<Triangle> triangles;        ///< indices of vertices, all valid
};

struct MeshSampling {
    double spacing_m = 0.001;         ///< a point for every square of this side
    std::size_t max_points = 500000;  ///< a mesh in wrong units must not fill the memory
    std::uint64_t seed = 1;
};

/// Points spread evenly over the area, with the normals of their faces. Triangles without area or
/// with corners that are not finite are left out. The same seed gives the same points.
[[nodiscard]] Cloud sample_surface(const TriangleMesh& mesh, const MeshSampling& sampling = {});

/// The mesh in an OBJ ("obj") or STL ("stl") file's bytes. The message says what is wrong; the
/// caller adds the file.
[[nodiscard]] Result<TriangleMesh> decode_mesh(std::string_view bytes, const std::string& format);

}  // namespace gripscan
