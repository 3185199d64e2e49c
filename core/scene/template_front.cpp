#include "core/scene/template_front.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace gripscan {
namespace {

/// Cosine of the viewing angle up to which stereo is sure to see a point; what hides may be
/// steeper.
constexpr float kFacing = 0.35F;
constexpr float kHides = 0.1F;
/// Cells of the depth map are this wide at the template: more than the points are apart.
constexpr float kCell_m = 0.0025F;
/// A surface as steep as kFacing is this deep across a cell.
constexpr float kBehind_m = 0.006F;

/// Nearest depth of each viewing direction.
class NearestDepth {
  public:
    NearestDepth(const Eigen::Vector3f& forward, float distance_m)
        : R_map_camera_(Eigen::Quaternionf::FromTwoVectors(forward, Eigen::Vector3f::UnitZ())
                            .toRotationMatrix()),
          cells_per_unit_(distance_m / kCell_m) {}

    void add(const Eigen::Vector3f& ray) {
        const Eigen::Vector3f local = R_map_camera_ * ray;
        if (local.z() <= 0.0F) return;
        const auto [place, fresh] = nearest_m_.try_emplace(key_of(local), local.z());
        if (!fresh) place->second = std::min(place->second, local.z());
    }

    [[nodiscard]] bool hides(const Eigen::Vector3f& ray) const {
        const Eigen::Vector3f local = R_map_camera_ * ray;
        if (local.z() <= 0.0F) return true;
        const auto found = nearest_m_.find(key_of(local));
        return found != nearest_m_.end() && local.z() > found->second + kBehind_m;
    }

  private:
    [[nodiscard]] std::int64_t key_of(const Eigen::Vector3f& local) const {
        const auto cell = [&](float slope) {
            return static_cast<std::int64_t>(std::floor(slope * cells_per_unit_)) + (1 << 20);
        };
        return cell(local.x() / local.z()) << 32 | cell(local.y() / local.z());
    }

    Eigen::Matrix3f R_map_camera_;
    float cells_per_unit_;
    std::unordered_map<std::int64_t, float> nearest_m_;
};

}  // namespace

Cloud template_front(const Cloud& thin, const Pose& T_camera_template,
                     const Eigen::Vector3f& viewpoint) {
    const Cloud posed = transformed(thin, T_camera_template);
    const Eigen::Vector3f middle = centroid(posed).cast<float>() - viewpoint;
    NearestDepth nearest(middle.normalized(), middle.norm());
    std::vector<float> facing(posed.size());
    for (std::size_t i = 0; i < posed.size(); ++i) {
        const Eigen::Vector3f ray = posed.points[i] - viewpoint;
        facing[i] = -posed.normals[i].dot(ray.normalized());
        if (facing[i] > kHides) nearest.add(ray);
    }
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < posed.size(); ++i) {
        if (facing[i] > kFacing && !nearest.hides(posed.points[i] - viewpoint)) front.push_back(i);
    }
    Cloud result = select(posed, front);
    result.viewpoint.reset();
    return result;
}

}  // namespace gripscan
