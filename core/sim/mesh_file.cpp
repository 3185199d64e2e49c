#include "core/sim/mesh_file.h"

#include <bit>

#include "core/base/atomic_file.h"

namespace gripscan::sim {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void put_point(std::string& bytes, const Eigen::Vector3d& p) {
    for (int i = 0; i < 3; ++i) put(bytes, static_cast<float>(p[i]));
}

}  // namespace

Status save_mesh_ply(const std::filesystem::path& path, const Mesh& mesh) {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\n"
        "property float y\nproperty float z\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n",
        mesh.vertices.size(), mesh.triangles.size());
    for (const Eigen::Vector3d& v : mesh.vertices) put_point(bytes, v);
    for (const auto& triangle : mesh.triangles) {
        put(bytes, std::uint8_t{3});
        for (const std::uint32_t index : triangle) put(bytes, static_cast<std::int32_t>(index));
    }
    return write_file_atomically(path, bytes);
}

Status save_samples_ply(const std::filesystem::path& path,
                        const std::vector<SurfaceSample>& samples) {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\n"
        "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
        "property float nz\nend_header\n",
        samples.size());
    for (const SurfaceSample& sample : samples) {
        put_point(bytes, sample.point_m);
        put_point(bytes, sample.normal);
    }
    return write_file_atomically(path, bytes);
}

}  // namespace gripscan::sim
