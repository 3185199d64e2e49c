#include "tests/tools/surface_distance.h"

#include <embree3/rtcore.h>

#include <limits>
#include <stdexcept>

namespace gripscan::test {

Eigen::Vector3d nearest_in_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Eigen::Vector3d ab = b - a;
    const Eigen::Vector3d ac = c - a;
    const double d1 = ab.dot(p - a);
    const double d2 = ac.dot(p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const double d3 = ab.dot(p - b);
    const double d4 = ac.dot(p - b);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + ab * (d1 / (d1 - d3));
    const double d5 = ab.dot(p - c);
    const double d6 = ac.dot(p - c);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    const double sum = va + vb + vc;
    return a + ab * (vb / sum) + ac * (vc / sum);
}

struct SurfaceDistance::Tree {
    Surface surface;
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = rtcNewScene(device);

    struct Search {
        const Surface* surface;
        Eigen::Vector3d p;
        double best = std::numeric_limits<double>::infinity();
    };

    static bool visit(RTCPointQueryFunctionArguments* arguments) {
        auto& search = *static_cast<Search*>(arguments->userPtr);
        const auto& [a, b, c] = search.surface->triangles[arguments->primID];
        const auto& v = search.surface->vertices;
        const double d = (nearest_in_triangle(search.p, v[a], v[b], v[c]) - search.p).norm();
        if (d >= search.best) return false;
        search.best = d;
        // A little more than the best so far: the tree's boxes are rounded to floats.
        arguments->query->radius = static_cast<float>(d * 1.0001 + 1e-6);
        return true;
    }

    void build() {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), surface.vertices.size()));
        for (const auto& v : surface.vertices) {
            for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(v[i]);
        }
        auto* indices = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), surface.triangles.size()));
        for (const auto& t : surface.triangles) {
            for (const std::uint32_t index : t) *indices++ = index;
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }
};

SurfaceDistance::SurfaceDistance(Surface surface) : tree_(std::make_unique<Tree>()) {
    if (surface.triangles.empty()) throw std::invalid_argument("a surface without triangles");
    tree_->surface = std::move(surface);
    tree_->build();
}

SurfaceDistance::~SurfaceDistance() {
    rtcReleaseScene(tree_->scene);
    rtcReleaseDevice(tree_->device);
}

double SurfaceDistance::distance_m(const Eigen::Vector3d& p_m) const {
    Tree::Search search{&tree_->surface, p_m};
    RTCPointQuery query{};
    query.x = static_cast<float>(p_m.x());
    query.y = static_cast<float>(p_m.y());
    query.z = static_cast<float>(p_m.z());
    query.radius = std::numeric_limits<float>::infinity();
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(tree_->scene, &query, &context, Tree::visit, &search);
    return search.best;
}

}  // namespace gripscan::test
