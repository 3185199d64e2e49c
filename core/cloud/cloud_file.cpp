#include "core/cloud/cloud_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>

#include "core/base/atomic_file.h"
#include "core/cloud/pcd_format.h"
#include "core/cloud/ply_format.h"
#include "core/cloud/point_table.h"
#include "core/cloud/triangle_mesh.h"
#include "core/cloud/xyz_format.h"

namespace gripscan {
namespace fs = std::filesystem;
namespace {

std::string format_of(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension.empty() ? extension : extension.substr(1);
}

Status check(const CloudFileOptions& options) {
    const double unit = options.metres_per_unit;
    if (!(unit > 0.0) || !std::isfinite(unit)) {
        return input_error("{} metres per unit make no sense", unit);
    }
    if (!(options.mesh_spacing_m > 0.0)) {
        return input_error("a mesh cannot be sampled every {} m", options.mesh_spacing_m);
    }
    return {};
}

Cloud sampled(TriangleMesh mesh, const CloudFileOptions& options) {
    for (auto& v : mesh.vertices) v *= options.metres_per_unit;
    return sample_surface(mesh,
                          {options.mesh_spacing_m, options.mesh_max_points, options.mesh_seed});
}

Result<Cloud> cloud_from_ply(PlyContent content, const CloudFileOptions& options) {
    if (content.triangles.empty()) {
        return cloud_from_table(content.points, options.metres_per_unit);
    }
    const auto* x = content.points.find("x");
    const auto* y = content.points.find("y");
    const auto* z = content.points.find("z");
    if (x == nullptr || y == nullptr || z == nullptr) {
        return input_error("the vertices have no properties x, y and z");
    }
    TriangleMesh mesh{{}, std::move(content.triangles)};
    for (std::size_t i = 0; i < content.points.rows; ++i) {
        mesh.vertices.emplace_back(x->values[i], y->values[i], z->values[i]);
    }
    return sampled(std::move(mesh), options);
}

Result<Cloud> decode(const std::string& bytes, const std::string& format,
                     const CloudFileOptions& options) {
    if (bytes.empty()) return input_error("the file is empty");
    const auto to_cloud = [&](const PointTable& table) {
        return cloud_from_table(table, options.metres_per_unit);
    };
    if (format == "pcd") return decode_pcd(bytes).and_then(to_cloud);
    if (format == "xyz") return decode_xyz(bytes).and_then(to_cloud);
    if (format == "ply") {
        auto content = decode_ply(bytes);
        if (!content) return forward_error(content.error());
        return cloud_from_ply(std::move(*content), options);
    }
    auto mesh = decode_mesh(bytes, format);
    if (!mesh) return forward_error(mesh.error());
    return sampled(std::move(*mesh), options);
}

Result<std::string> encode(const PointTable& table, const std::string& format,
                           PcdEncoding encoding) {
    if (format == "pcd") return encode_pcd(table, encoding);
    if (format == "xyz") return encode_xyz(table);
    return encode_ply(table,
                      encoding == PcdEncoding::kAscii ? PlyEncoding::kAscii : PlyEncoding::kBinary);
}

/// What of a cloud the format does not keep is taken away before the comparison.
Cloud as_kept_by(const std::string& format, Cloud cloud) {
    if (format != "pcd") cloud.viewpoint.reset();
    if (format == "xyz") {
        cloud.cell.clear();
        cloud.grid_width = 0;
        cloud.grid_height = 0;
    }
    return cloud;
}

bool equal(const Cloud& a, const Cloud& b) {
    return a.points == b.points && a.normals == b.normals && a.intensity == b.intensity &&
           a.sigma == b.sigma && a.seen == b.seen && a.cell == b.cell &&
           a.grid_width == b.grid_width && a.grid_height == b.grid_height &&
           a.viewpoint == b.viewpoint;
}

/// Nothing of the cloud may be lost on the way into the table, such as a normal that is none.
bool complete(const Cloud& stored, const Cloud& cloud) {
    return stored.size() == cloud.size() && stored.normals.size() == cloud.normals.size() &&
           stored.intensity.size() == cloud.intensity.size() &&
           stored.sigma.size() == cloud.sigma.size() && stored.seen.size() == cloud.seen.size();
}

Status write_and_compare(const fs::path& temporary, const std::string& bytes, const Cloud& expected,
                         const std::string& format) {
    std::ofstream file(temporary, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
        return input_error("{}; check that the folder exists, may be written to and has space",
                           std::strerror(errno));
    }
    const auto read = read_whole_file(temporary);
    if (!read) return forward_error(read.error());
    const auto cloud = decode(*read, format, {});
    if (!cloud) return input_error("what was written does not read: {}", cloud.error().message);
    if (!equal(*cloud, expected)) return input_error("what was written reads back differently");
    return {};
}

Status save(const fs::path& path, const Cloud& cloud, const std::string& format,
            const CloudFileOptions& options) {
    if (Status status = check(options); !status) return status;
    const PointTable table = table_from_cloud(cloud, options.metres_per_unit);
    const auto stored = cloud_from_table(table, 1.0);
    if (!stored) return forward_error(stored.error());
    if (!complete(*stored, cloud)) {
        return input_error("the cloud has points, normals or deviations that are no numbers");
    }
    const auto bytes = encode(table, format, options.encoding);
    if (!bytes) return forward_error(bytes.error());
    return write_file_atomically(path, [&](const fs::path& temporary) {
        return write_and_compare(temporary, *bytes, as_kept_by(format, *stored), format);
    });
}

}  // namespace

Result<Cloud> load_cloud(const fs::path& path, const CloudFileOptions& options) {
    const std::string format = format_of(path);
    constexpr std::array<std::string_view, 5> kFormats{"pcd", "ply", "xyz", "obj", "stl"};
    if (std::find(kFormats.begin(), kFormats.end(), format) == kFormats.end()) {
        return input_error(
            "cannot read {}: clouds are .pcd, .ply or .xyz, meshes .ply, .obj or "
            ".stl",
            path.string());
    }
    if (const Status status = check(options); !status) return forward_error(status.error());
    const auto bytes = read_whole_file(path);
    if (!bytes) return forward_error(bytes.error());
    auto cloud = decode(*bytes, format, options);
    if (!cloud) return input_error("cannot read {}: {}", path.string(), cloud.error().message);
    return cloud;
}

Status save_cloud(const fs::path& path, const Cloud& cloud, const CloudFileOptions& options) {
    const std::string format = format_of(path);
    if (format != "pcd" && format != "ply" && format != "xyz") {
        return input_error("cannot write {}: clouds are .pcd, .ply or .xyz", path.string());
    }
    if (const Status status = save(path, cloud, format, options); !status) {
        return input_error("cannot write {}: {}", path.string(), status.error().message);
    }
    return {};
}

}  // namespace gripscan
