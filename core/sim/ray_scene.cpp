#include "core/sim/ray_scene.h"

#include <embree3/rtcore.h>

#include <limits>

namespace gripscan::sim {
namespace {

/// Surfaces nearer than this to a ray's end do not count: they are where the ray starts.
constexpr float kSelf_m = 2e-5F;

void attach_mesh(RTCDevice device, RTCScene scene, const Mesh& mesh, unsigned id) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertices.size()));
    for (const Eigen::Vector3d& v : mesh.vertices) {
        for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(v[i]);
    }
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle) *indices++ = index;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
}

RTCScene new_scene(RTCDevice device) {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    return scene;
}

void set_ray(RTCRay& ray, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
             float near, float far) {
    ray.org_x = origin.x();
    ray.org_y = origin.y();
    ray.org_z = origin.z();
    ray.dir_x = direction.x();
    ray.dir_y = direction.y();
    ray.dir_z = direction.z();
    ray.tnear = near;
    ray.tfar = far;
    ray.time = 0.0F;
    ray.mask = 0xFFFFFFFFU;
    ray.id = 0;
    ray.flags = 0;
}

}  // namespace

struct RayScene::Impl {
    RTCDevice device = nullptr;
    RTCScene top = nullptr;
    std::array<RTCScene, SceneModel::kBodies> scenes{};
    std::array<RTCGeometry, SceneModel::kBodies> instances{};
    std::array<Eigen::Isometry3f, SceneModel::kBodies> T_world_body;
    std::array<Eigen::Isometry3f, SceneModel::kBodies> T_body_world;

    ~Impl() {
        for (RTCGeometry instance : instances) {
            if (instance != nullptr) rtcReleaseGeometry(instance);
        }
        for (RTCScene scene : scenes) {
            if (scene != nullptr) rtcReleaseScene(scene);
        }
        if (top != nullptr) rtcReleaseScene(top);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    void add_body(std::size_t index, const Body& body) {
        RTCScene scene = scenes[index] = new_scene(device);
        for (unsigned i = 0; i < body.parts.size(); ++i) {
            attach_mesh(device, scene, body.parts[i].mesh, i);
        }
        rtcCommitScene(scene);
        RTCGeometry instance = instances[index] =
            rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(instance, scene);
        rtcAttachGeometryByID(top, instance, static_cast<unsigned>(index));
    }
};

RayScene::RayScene(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

Result<RayScene> RayScene::create(const SceneModel& model) {
    auto impl = std::make_unique<Impl>();
    // Trees are small: one thread builds them, and builds them the same every time.
    impl->device = rtcNewDevice("threads=1");
    if (impl->device == nullptr) {
        return device_error("the ray tracer (Embree) does not start: error {}",
                            static_cast<int>(rtcGetDeviceError(nullptr)));
    }
    impl->top = new_scene(impl->device);
    for (std::size_t i = 0; i < SceneModel::kBodies; ++i) impl->add_body(i, model.bodies[i]);
    RayScene scene(std::move(impl));
    std::array<Pose, SceneModel::kBodies> at_rest;
    at_rest.fill(Pose::Identity());
    scene.place(at_rest);
    return scene;
}

void RayScene::place(const std::array<Pose, SceneModel::kBodies>& T_world_body) {
    for (std::size_t i = 0; i < SceneModel::kBodies; ++i) {
        impl_->T_world_body[i] = T_world_body[i].cast<float>();
        impl_->T_body_world[i] = T_world_body[i].inverse().cast<float>();
        const Eigen::Matrix4f M = impl_->T_world_body[i].matrix();
        rtcSetGeometryTransform(impl_->instances[i], 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, M.data());
        rtcCommitGeometry(impl_->instances[i]);
    }
    rtcCommitScene(impl_->top);
}

bool RayScene::trace(const Eigen::Vector3f& origin_m, const Eigen::Vector3f& direction,
                     Hit& hit) const {
    RTCRayHit query{};
    set_ray(query.ray, origin_m, direction, 0.0F, std::numeric_limits<float>::infinity());
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(impl_->top, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    hit.distance_m = query.ray.tfar;
    hit.body = query.hit.instID[0];
    hit.part = query.hit.geomID;
    const Eigen::Vector3f normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
    hit.normal = (impl_->T_world_body[hit.body].linear() * normal).normalized();
    if (hit.normal.dot(direction) > 0.0F) hit.normal = -hit.normal;
    hit.local_m = impl_->T_body_world[hit.body] * (origin_m + hit.distance_m * direction);
    return true;
}

bool RayScene::blocked(const Eigen::Vector3f& from_m, const Eigen::Vector3f& to_m) const {
    const Eigen::Vector3f step = to_m - from_m;
    const float length = step.norm();
    RTCRay ray{};
    set_ray(ray, from_m, step / length, kSelf_m, length - kSelf_m);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(impl_->top, &context, &ray);
    return ray.tfar < 0.0F;
}

}  // namespace gripscan::sim
