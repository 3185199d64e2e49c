#include "core/scene/object_split.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/cloud/kd_tree.h"
#include "core/scene/cloud_pieces.h"

namespace gripscan {
namespace {

constexpr float kNoiseSigmas = 3.0F;

/// What a point of the scene is taken for.
enum class Owner : std::uint8_t { kGripper, kReachesIn, kObject, kScattered };

/// Noise of a point along a direction, m.
float sigma_along(const Surface& scene, std::size_t i, const Eigen::Vector3f& n) {
    return scene.sigma_along(i, n);
}

/// Whether a point lies on the template's surface: near it along its normal, and not far beside it.
class TemplateSurface {
  public:
    TemplateSurface(const GripperTemplate& gripper, const Pose& T_camera_gripper,
                    const ObjectSplitSettings& settings)
        : cloud_(gripper.cloud),
          tree_(gripper.cloud.points),
          T_gripper_camera_(T_camera_gripper.inverse()),
          settings_(settings) {}

    [[nodiscard]] bool holds(const Surface& scene, std::size_t i) const {
        const Eigen::Vector3f p =
            (T_gripper_camera_ * scene.points[i].cast<double>()).cast<float>();
        const auto near = tree_.nearest_within(p, static_cast<float>(settings_.surface_reach_m));
        if (!near) return false;
        const Eigen::Vector3f n = cloud_.normals[near->index];
        const Eigen::Vector3f n_camera =
            (T_gripper_camera_.linear().transpose() * n.cast<double>()).cast<float>();
        const float limit_m = static_cast<float>(settings_.surface_margin_m) +
                              kNoiseSigmas * sigma_along(scene, i, n_camera);
        return std::abs(n.dot(p - cloud_.points[near->index])) < limit_m;
    }

  private:
    const Cloud& cloud_;
    KdTree tree_;
    Pose T_gripper_camera_;
    const ObjectSplitSettings& settings_;
};

std::vector<Owner> owners_of(const GripperTemplate& gripper, const Surface& scene,
                             const ObjectSplit& split, const ObjectSplitSettings& settings) {
    const TemplateSurface surface(gripper, split.gripper.T_camera_gripper, settings);
    const Pose T_cuboid_camera = split.gripper_cuboid.T_frame_cuboid.inverse();
    std::vector<Owner> owners(scene.size(), Owner::kObject);
    for (std::size_t i = 0; i < scene.size(); ++i) {
        const Eigen::Vector3d p = scene.points[i].cast<double>();
        const bool inside =
            ((T_cuboid_camera * p).cwiseAbs().array() <= split.gripper_cuboid.half_m.array()).all();
        if (surface.holds(scene, i)) {
            owners[i] = Owner::kGripper;
        } else if (inside) {
            owners[i] = Owner::kReachesIn;
        }
    }
    return owners;
}

std::vector<std::size_t> indices_of(const std::vector<Owner>& owners, Owner wanted) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < owners.size(); ++i) {
        if (owners[i] == wanted) indices.push_back(i);
    }
    return indices;
}

/// Pieces too small to be surface are chance: debris at silhouettes, edges of the gripper.
void mark_scattered(const Cloud& scene, const ObjectSplitSettings& settings, double spacing_m,
                    std::vector<Owner>& owners) {
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < owners.size(); ++i) {
        if (owners[i] != Owner::kGripper) rest.push_back(i);
    }
    const auto least = static_cast<std::size_t>(settings.least_piece_m2 / (spacing_m * spacing_m));
    for (const std::size_t i : points_of_small_pieces(scene, rest, least, 4.0 * spacing_m)) {
        owners[i] = Owner::kScattered;
    }
}

bool by_cuboid(const ObjectSplitSettings& settings, std::size_t outside, std::size_t reaching_in) {
    if (settings.trim != TrimBy::kAuto) return settings.trim == TrimBy::kCuboid;
    return static_cast<double>(reaching_in) <=
           settings.most_lost * static_cast<double>(outside + reaching_in);
}

void share_out(const Cloud& scene, const ObjectSplitSettings& settings, std::vector<Owner> owners,
               ObjectSplit& split) {
    const std::size_t outside = indices_of(owners, Owner::kObject).size();
    split.reaching_in = indices_of(owners, Owner::kReachesIn).size();
    split.scattered = indices_of(owners, Owner::kScattered).size();
    const bool cuboid = by_cuboid(settings, outside, split.reaching_in);
    split.trimmed_by = cuboid ? TrimBy::kCuboid : TrimBy::kSurface;
    for (Owner& owner : owners) {
        if (owner == Owner::kReachesIn) owner = cuboid ? Owner::kGripper : Owner::kObject;
    }
    split.object = select(scene, indices_of(owners, Owner::kObject));
    split.gripper_part = select(scene, indices_of(owners, Owner::kGripper));
    if (!split.object.empty()) split.object_cuboid = cuboid_around(split.object.points);
}

std::string sentence_of(const ObjectSplit& split) {
    if (!split.gripper.usable()) {
        return fmt::format("the gripper was not found: {}", split.gripper.sentence);
    }
    const std::string unverified =
        split.gripper.trusted
            ? ""
            : fmt::format("the gripper was not verified: {}; ", split.gripper.sentence);
    return unverified + fmt::format(
                            "{} points of the object, {} of the gripper; {} points reach into the "
                            "gripper's cuboid and "
                            "are {}; {} scattered ones belong to neither",
                            split.object.size(), split.gripper_part.size(), split.reaching_in,
                            split.trimmed_by == TrimBy::kCuboid ? "lost with it"
                                                                : "kept, trimmed by its surface",
                            split.scattered);
}

/// Split once, matched again with what is the gripper's, so that the object does not pull at it.
void match_own_points(const GripperTemplate& gripper, const Cloud& scene, const Surface& surface,
                      const std::optional<Pose>& T_start, const ObjectSplitSettings& settings,
                      ObjectSplit& split) {
    const std::vector<Owner> owners = owners_of(gripper, surface, split, settings);
    const auto own = make_surface(select(scene, indices_of(owners, Owner::kGripper)));
    if (!own) return;
    GripperMatch again = match_again(gripper, *own, surface, T_start, split.gripper);
    if (again.trusted) split.gripper = std::move(again);
}

}  // namespace

std::string_view word(TrimBy trim) {
    constexpr std::array<std::string_view, 3> kWords{"auto", "cuboid", "surface"};
    return kWords[static_cast<std::size_t>(trim)];
}

Result<ObjectSplit> split_object(const GripperTemplate& gripper, const Cloud& scene,
                                 const std::optional<Pose>& T_start,
                                 const ObjectSplitSettings& settings) {
    const auto surface = make_surface(scene);
    if (!surface) return forward_error(surface.error());
    ObjectSplit split;
    split.gripper = match_gripper(gripper, *surface, T_start);
    if (split.gripper.trusted) match_own_points(gripper, scene, *surface, T_start, settings, split);
    split.gripper_cuboid =
        moved(widened(gripper.cuboid, settings.margins), split.gripper.T_camera_gripper);
    if (split.gripper.usable()) {
        std::vector<Owner> owners = owners_of(gripper, *surface, split, settings);
        mark_scattered(scene, settings, surface->spacing_m, owners);
        share_out(scene, settings, std::move(owners), split);
    } else {
        split.gripper_part = scene;
    }
    split.sentence = sentence_of(split);
    return split;
}

}  // namespace gripscan
