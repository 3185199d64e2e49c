#include "core/sim/swept_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gripscan::sim {
namespace {

constexpr double kSlice_m = 0.002;
constexpr double kAir_m = 0.0002;
constexpr int kSegments = 96;

/// Largest distance from the axis in every slice along it.
class Slices {
  public:
    Slices(double low_m, double high_m, double slack_m)
        : low_m_(low_m - slack_m),
          slack_m_(slack_m),
          radius_m_(static_cast<std::size_t>((high_m - low_m + 2.0 * slack_m) / kSlice_m) + 1,
                    0.0) {}

    /// A triangle's distance from the axis is largest at a corner of it (or of the piece of it in
    /// a slice), so no slice between its corners needs more than their maximum.
    void add(const std::array<Eigen::Vector3d, 3>& corners) {
        double radius = 0.0;
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const Eigen::Vector3d& p : corners) {
            radius = std::max(radius, std::hypot(p.x(), p.y()));
            low = std::min(low, p.z());
            high = std::max(high, p.z());
        }
        for (std::size_t i = index(low - slack_m_); i <= index(high + slack_m_); ++i) {
            radius_m_[i] = std::max(radius_m_[i], radius + slack_m_);
        }
    }

    [[nodiscard]] std::vector<Eigen::Vector2d> profile() const {
        // The flat sides of the polygon must clear the circle.
        const double stretch = 1.0 / std::cos(std::numbers::pi / kSegments);
        std::vector<Eigen::Vector2d> points;
        for (std::size_t i = 0; i < radius_m_.size(); ++i) {
            const double radius = radius_m_[i] * stretch + kAir_m;
            const double z = low_m_ + static_cast<double>(i) * kSlice_m;
            points.emplace_back(radius, z - kAir_m);
            points.emplace_back(radius, z + kSlice_m + kAir_m);
        }
        return points;
    }

  private:
    [[nodiscard]] std::size_t index(double z_m) const {
        const double i = std::floor((z_m - low_m_) / kSlice_m);
        return std::min(static_cast<std::size_t>(std::max(i, 0.0)), radius_m_.size() - 1);
    }

    double low_m_;
    double slack_m_;
    std::vector<double> radius_m_;
};

/// Everything that turns, in tool0.
Mesh turning_parts(const SceneModel& model) {
    const auto T_world_body = body_poses(JointAngles{});
    Mesh mesh;
    for (std::size_t i = 0; i < SceneModel::kBodies; ++i) {
        if (!turns_with_joint6(i)) continue;
        const Pose T_tool_body = T_world_body[SceneModel::kTool].inverse() * T_world_body[i];
        for (const Part& part : model.bodies[i].parts) append(mesh, part.mesh, T_tool_body);
    }
    return mesh;
}

}  // namespace

SceneModel swept_scene(const SceneModel& model, double slack_m) {
    const Mesh mesh = turning_parts(model);
    SceneModel scene;
    if (mesh.vertices.empty()) return scene;
    const auto by_z = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return a.z() < b.z();
    };
    const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(), by_z);
    Slices slices(low->z(), high->z(), slack_m);
    for (const auto& [a, b, c] : mesh.triangles) {
        slices.add({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    }
    scene.bodies[SceneModel::kTool].parts = {
        {"swept volume", lathe(slices.profile(), kSegments), Material{}}};
    return scene;
}

}  // namespace gripscan::sim
