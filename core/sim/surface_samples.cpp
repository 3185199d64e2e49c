#include "core/sim/surface_samples.h"

#include <cmath>

namespace gripscan::sim {
namespace {

/// Evenly spread pairs in [0, 1)²: the R2 sequence (Roberts 2018).
Eigen::Vector2d r2_point(std::size_t i) {
    const double x = 0.5 + 0.7548776662466927 * static_cast<double>(i);
    const double y = 0.5 + 0.5698402909980532 * static_cast<double>(i);
    return {x - std::floor(x), y - std::floor(y)};
}

}  // namespace

std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double spacing_m) {
    std::vector<SurfaceSample> samples;
    double owed = 0.0;  // small triangles share a sample
    for (const auto& [ia, ib, ic] : mesh.triangles) {
        const Eigen::Vector3d a = mesh.vertices[ia];
        const Eigen::Vector3d ab = mesh.vertices[ib] - a;
        const Eigen::Vector3d ac = mesh.vertices[ic] - a;
        const Eigen::Vector3d n = ab.cross(ac);
        owed += 0.5 * n.norm() / (spacing_m * spacing_m);
        const auto count = static_cast<std::size_t>(std::max(0.0, std::floor(owed + 0.5)));
        owed -= static_cast<double>(count);
        for (std::size_t i = 0; i < count; ++i) {
            Eigen::Vector2d st = r2_point(i);
            if (st.sum() > 1.0) st = Eigen::Vector2d::Ones() - st;
            samples.push_back({a + st.x() * ab + st.y() * ac, n.normalized()});
        }
    }
    return samples;
}

}  // namespace gripscan::sim
