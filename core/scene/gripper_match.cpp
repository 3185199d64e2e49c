#include "core/scene/gripper_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "core/registration/point_to_plane.h"
#include "core/registration/quality.h"
#include "core/registration/visibility.h"

namespace gripscan {
namespace {

/// Cosine of the viewing angle up to which a template point is looked for.
constexpr float kFacing = 0.3F;
/// First reach of the search: an arm's pose may differ so much between two sessions.
constexpr double kFirstGate_m = 0.012;
constexpr double kLastGate_m = 0.003;
constexpr std::size_t kCoarsePoints = 1500;
/// Last reach: what the gripper holds may lie some millimetres beside its own faces.
constexpr double kFineGate_m = 0.0012;
constexpr std::size_t kFinePoints = 6000;
/// A template point is found when the scene has one this near, with a normal alike.
constexpr float kFound_m = 0.0015F;
constexpr float kSameNormal = 0.7F;
/// And contradicted when the camera looked through further than this behind it.
constexpr float kLookedThrough_m = 0.004F;
/// What speaks for a match: of what faces the camera and is not hidden by the held part. Steep
/// faces and dark ones are missing even in a good view.
constexpr double kLeastMatched = 0.45;
/// And of all that faces the camera: the held part may not hide nearly everything.
constexpr double kLeastOfAll = 0.10;
constexpr double kMostContradicted = 0.10;
constexpr double kMostRms_m = 0.0015;
/// Turns tried where the robot's angle does not lead to a match.
constexpr int kSearchedTurns = 36;

/// What of the template faces the camera with the gripper at T, in the camera frame.
Cloud facing_part(const Cloud& thin, const Pose& T, const Eigen::Vector3f& viewpoint) {
    const Cloud posed = transformed(thin, T);
    std::vector<std::size_t> facing;
    for (std::size_t i = 0; i < posed.size(); ++i) {
        const Eigen::Vector3f ray = (posed.points[i] - viewpoint).normalized();
        if (-posed.normals[i].dot(ray) > kFacing) facing.push_back(i);
    }
    Cloud front = select(posed, facing);
    front.viewpoint.reset();  // its points come from many views
    return front;
}

struct Shares {
    double matched = 0.0;
    double contradicted = 0.0;
    double hidden = 0.0;

    [[nodiscard]] double found() const { return matched / std::max(1.0 - hidden, 1e-9); }
};

/// Of the template's points that face the camera, moved by D.
Shares shares_at(const Surface& part, const Surface& scene, const DepthMap* map, const Pose& D) {
    const Eigen::Matrix3f R = D.linear().cast<float>();
    const Eigen::Vector3f t = D.translation().cast<float>();
    std::size_t matched = 0;
    std::size_t contradicted = 0;
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Eigen::Vector3f p = R * part.points[i] + t;
        const auto near = scene.tree.nearest_within(p, kFound_m);
        if (near && scene.normals[near->index].dot(R * part.normals[i]) > kSameNormal) {
            ++matched;
            continue;
        }
        const Sight sight = map != nullptr ? map->look(p, kLookedThrough_m) : Sight::kNothing;
        if (sight == Sight::kInFront) ++contradicted;
        if (sight == Sight::kHidden) ++hidden;
    }
    const auto n = static_cast<double>(std::max<std::size_t>(1, part.size()));
    return {static_cast<double>(matched) / n, static_cast<double>(contradicted) / n,
            static_cast<double>(hidden) / n};
}

struct Gates {
    double first_m;
    double last_m;
};

/// The start, moved onto the scene by shape with some of the points.
Pose settle(const Surface& part, const Surface& scene, const Pose& start, Gates gates,
            std::size_t points) {
    const auto part_sample = spread_sample(part, points);
    const auto scene_sample = spread_sample(scene, points);
    RefineSettings settings;
    settings.first_gate_m = gates.first_m;
    settings.last_gate_m = gates.last_m;
    settings.tolerance = 1e-5;
    return refine(part, scene, {part_sample, scene_sample}, start, settings);
}

/// Where the surfaces come to rest from a start.
struct Settled {
    Pose T_camera_gripper = Pose::Identity();
    Shares shares;
    std::optional<Surface> part;  ///< of the template, as it faces the camera there
    Pose moved = Pose::Identity();
};

Settled settled_from(const GripperTemplate& gripper, const Surface& scene, const DepthMap* map,
                     const Pose& T_start) {
    const Eigen::Vector3f viewpoint = scene.viewpoint.value_or(Eigen::Vector3f::Zero());
    Settled settled{T_start, {}, std::nullopt, Pose::Identity()};
    auto part = make_surface(facing_part(gripper.thin, T_start, viewpoint));
    if (!part) return settled;
    settled.moved =
        settle(*part, scene, Pose::Identity(), {kFirstGate_m, kLastGate_m}, kCoarsePoints);
    settled.T_camera_gripper = settled.moved * T_start;
    settled.shares = shares_at(*part, scene, map, settled.moved);
    settled.part = std::move(*part);
    return settled;
}

double score(const Shares& shares) {
    return shares.matched - shares.contradicted;
}

bool convincing(const Shares& shares) {
    return shares.found() >= kLeastMatched && shares.matched >= kLeastOfAll &&
           shares.contradicted <= kMostContradicted;
}

/// The best of many turns about the axis.
Settled searched(const GripperTemplate& gripper, const Surface& scene, const DepthMap* map,
                 Settled best) {
    for (int k = 0; k < kSearchedTurns; ++k) {
        const double turn_rad = 2.0 * std::numbers::pi * k / kSearchedTurns;
        Settled other = settled_from(gripper, scene, map, turn_about(gripper.axis, turn_rad));
        if (!best.part || score(other.shares) > score(best.shares)) best = std::move(other);
    }
    return best;
}

/// With all points, from where it has settled; the part that faces the camera is taken anew.
void finish(const GripperTemplate& gripper, const Surface& scene, const DepthMap* map,
            const Settled& settled, GripperMatch& match_found) {
    const Eigen::Vector3f viewpoint = scene.viewpoint.value_or(Eigen::Vector3f::Zero());
    const auto part = make_surface(facing_part(gripper.thin, settled.T_camera_gripper, viewpoint));
    if (!part) return;
    const Pose fine =
        settle(*part, scene, Pose::Identity(), {kLastGate_m, kFineGate_m}, kFinePoints);
    match_found.T_camera_gripper = fine * settled.T_camera_gripper;
    const Shares shares = shares_at(*part, scene, map, fine);
    match_found.matched = shares.matched;
    match_found.contradicted = shares.contradicted;
    match_found.hidden = shares.hidden;
    const auto sample = spread_sample(*part, kCoarsePoints);
    const auto matches = match(*part, scene, {sample, {}}, fine, {.gate_m = kFineGate_m});
    match_found.rms_m = residual_statistics(matches).rms_m;
    const Eigen::Vector3d direction = settled.T_camera_gripper.linear() * gripper.axis.direction;
    match_found.observability = turn_observability(*part, scene, matches, fine, direction);
}

void compare_with_start(const GripperTemplate& gripper, const Pose& T_start, GripperMatch& found) {
    const Pose beside = found.T_camera_gripper * T_start.inverse();
    found.beside_rad = rotation_angle_rad(beside.linear());
    const Eigen::Vector3d middle_m = T_start * gripper.cuboid.T_frame_cuboid.translation();
    found.beside_m = (beside * middle_m - middle_m).norm();
}

void judge(GripperMatch& found) {
    const Shares shares{found.matched, found.contradicted, found.hidden};
    found.trusted = convincing(shares) && found.rms_m <= kMostRms_m;
    found.sentence = fmt::format(
        "of the gripper that should be seen {:.0f} % is found to {:.2f} mm, least {:.0f} %; "
        "through "
        "{:.0f} % the camera looks, most {:.0f} %; {:.0f} % is hidden",
        100.0 * shares.found(), kMmPerM * found.rms_m, 100.0 * kLeastMatched,
        100.0 * found.contradicted, 100.0 * kMostContradicted, 100.0 * found.hidden);
    if (found.trusted && found.observability < kLeastObservability) {
        found.sentence += "; its shape does not show the turn, which is the robot's";
    }
}

}  // namespace

std::optional<Pose> expected_pose(const GripperTemplate& gripper,
                                  std::optional<double> joint6_rad) {
    if (!gripper.joint6_rad || !joint6_rad) return std::nullopt;
    return turn_about(gripper.axis, *joint6_rad - *gripper.joint6_rad);
}

GripperMatch match_gripper(const GripperTemplate& gripper, const Surface& scene,
                           const std::optional<Pose>& T_start) {
    std::optional<DepthMap> map;
    if (scene.viewpoint) map.emplace(scene);
    const DepthMap* looks = map ? &*map : nullptr;
    GripperMatch found;
    Settled settled;
    if (T_start) settled = settled_from(gripper, scene, looks, *T_start);
    if (!settled.part || !convincing(settled.shares)) {
        settled = searched(gripper, scene, looks, std::move(settled));
        found.searched = true;
    }
    found.T_camera_gripper = settled.T_camera_gripper;
    finish(gripper, scene, looks, settled, found);
    if (T_start) compare_with_start(gripper, *T_start, found);
    judge(found);
    return found;
}

}  // namespace gripscan
