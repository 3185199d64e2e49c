#include "core/scene/gripper_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/units.h"
#include "core/registration/point_to_plane.h"
#include "core/registration/quality.h"
#include "core/registration/visibility.h"
#include "core/scene/template_front.h"

namespace gripscan {
namespace {

/// Reaches from a start near the answer, and with all points at the end; never below what the
/// scene's points are apart.
constexpr double kFirstGate_m = 0.004;
constexpr double kMiddleGate_m = 0.002;
constexpr double kLastGate_m = 0.001;
constexpr double kGateSpacings = 1.5;
constexpr float kAlikeNormals = 0.8F;
constexpr std::size_t kCoarsePoints = 900;
constexpr std::size_t kFinePoints = 8000;
constexpr int kFineRounds = 2;
/// Starts beside the given one: two sessions may differ so much.
constexpr double kTurnedStart_rad = 1.2 * kRadPerDeg;
constexpr double kShiftedStart_m = 0.002;
/// A pose further from where the robot says is not believed, however well it fits.
constexpr double kMostBeside_rad = 2.5 * kRadPerDeg;
constexpr double kMostBeside_m = 0.005;
/// Turns tried where the robot's angle is not known, and the first reach of each.
constexpr int kSearchedTurns = 36;
constexpr double kSearchGate_m = 0.007;

/// A template point is found when the scene has one this near, with a normal alike; where only the
/// robot tells the pose, this near.
constexpr float kFound_m = 0.0015F;
constexpr float kRoughlyFound_m = 0.003F;
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
/// Where the robot says it is, this much must be found before its word is taken.
constexpr double kLeastAtRobots = 0.30;

/// The scene, and the depth map of what the camera saw; null without a viewpoint.
struct Seen {
    const Surface& scene;
    const DepthMap* map;

    [[nodiscard]] Eigen::Vector3f viewpoint() const {
        return scene.viewpoint.value_or(Eigen::Vector3f::Zero());
    }
};

struct Shares {
    double matched = 0.0;
    double contradicted = 0.0;
    double hidden = 0.0;
    double fit = 0.0;  ///< mean over the points: 1 on the scene's surface, 0 at kFound_m and beyond

    [[nodiscard]] double found() const { return matched / std::max(1.0 - hidden, 1e-9); }
    [[nodiscard]] double score() const { return fit - contradicted; }
};

/// Of the template's points that the camera could see, moved by D.
Shares shares_at(const Surface& part, const Seen& seen, const Pose& D, float reach_m) {
    const Eigen::Matrix3f R = D.linear().cast<float>();
    const Eigen::Vector3f t = D.translation().cast<float>();
    Shares sums;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Eigen::Vector3f p = R * part.points[i] + t;
        const Eigen::Vector3f n = R * part.normals[i];
        const auto near = seen.scene.tree.nearest_within(p, reach_m);
        if (near && seen.scene.normals[near->index].dot(n) > kSameNormal) {
            const float off = n.dot(p - seen.scene.points[near->index]) / kFound_m;
            sums.matched += 1.0;
            if (std::abs(off) < 1.0F) sums.fit += (1.0F - off * off) * (1.0F - off * off);
            continue;
        }
        const Sight sight =
            seen.map != nullptr ? seen.map->look(p, kLookedThrough_m) : Sight::kNothing;
        if (sight == Sight::kInFront) sums.contradicted += 1.0;
        if (sight == Sight::kHidden) sums.hidden += 1.0;
    }
    const auto n = static_cast<double>(std::max<std::size_t>(1, part.size()));
    return {sums.matched / n, sums.contradicted / n, sums.hidden / n, sums.fit / n};
}

struct Gates {
    double first_m;
    double last_m;
};

/// The template's front, moved onto the scene by shape with some of the points.
Pose settle(const Surface& part, const Surface& scene, Gates gates, std::size_t points) {
    const auto part_sample = spread_sample(part, points);
    const auto scene_sample = spread_sample(scene, points);
    const double least_m = kGateSpacings * scene.spacing_m;
    RefineSettings settings;
    settings.first_gate_m = std::max(gates.first_m, least_m);
    settings.last_gate_m = std::max(gates.last_m, least_m);
    settings.tolerance = 1e-5;
    settings.shrink = 0.85;
    settings.iterations = 40;
    settings.min_normal_cos = kAlikeNormals;
    return refine(part, scene, {part_sample, scene_sample}, Pose::Identity(), settings);
}

/// Where the surfaces come to rest from a start; nothing where the template shows no surface.
struct Settled {
    Pose T_camera_gripper = Pose::Identity();
    Shares shares;
};

std::optional<Settled> settled_from(const GripperTemplate& gripper, const Seen& seen,
                                    const Pose& T_start, Gates gates) {
    const auto part = make_surface(template_front(gripper.thin, T_start, seen.viewpoint()));
    if (!part) return std::nullopt;
    const Pose moved = settle(*part, seen.scene, gates, kCoarsePoints);
    return Settled{moved * T_start, shares_at(*part, seen, moved, kFound_m)};
}

std::optional<Settled> best_of(const GripperTemplate& gripper, const Seen& seen,
                               const std::vector<Pose>& starts, Gates gates) {
    std::optional<Settled> best;
    for (const Pose& T_start : starts) {
        const auto settled = settled_from(gripper, seen, T_start, gates);
        if (!settled) continue;
        if (!best || settled->shares.score() > best->shares.score()) best = settled;
    }
    return best;
}

/// The start itself and six turned and six shifted ones around it.
std::vector<Pose> starts_near(const GripperTemplate& gripper, const Pose& T_start) {
    const Eigen::Vector3d middle_m = T_start * gripper.cuboid.T_frame_cuboid.translation();
    std::vector<Pose> starts{T_start};
    for (int k = 0; k < 6; ++k) {
        for (const double side : {-1.0, 1.0}) {
            Vector6d motion = Vector6d::Zero();
            motion(k) = side * (k < 3 ? kTurnedStart_rad : kShiftedStart_m);
            starts.push_back(motion_about(motion, middle_m) * T_start);
        }
    }
    return starts;
}

std::vector<Pose> starts_all_around(const GripperTemplate& gripper) {
    std::vector<Pose> starts;
    for (int k = 0; k < kSearchedTurns; ++k) {
        starts.push_back(turn_about(gripper.axis, 2.0 * std::numbers::pi * k / kSearchedTurns));
    }
    return starts;
}

/// With many points, from where it has settled; what faces the camera is taken anew.
void finish(const GripperTemplate& gripper, const Surface& own, const Seen& seen,
            GripperMatch& found) {
    for (int round = 0; round < kFineRounds; ++round) {
        const Pose T_before = found.T_camera_gripper;
        const auto part = make_surface(template_front(gripper.thin, T_before, seen.viewpoint()));
        if (!part) return;
        const Pose moved = settle(*part, own, {kMiddleGate_m, kLastGate_m}, kFinePoints);
        found.T_camera_gripper = moved * T_before;
        const Shares shares = shares_at(*part, seen, moved, kFound_m);
        found.matched = shares.matched;
        found.contradicted = shares.contradicted;
        found.hidden = shares.hidden;
        const auto sample = spread_sample(*part, kFinePoints);
        const auto matches = match(*part, own, {sample, {}}, moved, {.gate_m = kFound_m});
        found.rms_m = residual_statistics(matches).rms_m;
        found.observability = turn_observability(*part, own, matches, moved,
                                                 T_before.linear() * gripper.axis.direction);
    }
}

void compare_with_start(const GripperTemplate& gripper, const Pose& T_start, GripperMatch& found) {
    const Pose beside = found.T_camera_gripper * T_start.inverse();
    found.beside_rad = rotation_angle_rad(beside.linear());
    const Eigen::Vector3d middle_m = T_start * gripper.cuboid.T_frame_cuboid.translation();
    found.beside_m = (beside * middle_m - middle_m).norm();
}

void judge(GripperMatch& found) {
    const double of_visible = found.matched / std::max(1.0 - found.hidden, 1e-9);
    const bool fits = of_visible >= kLeastMatched && found.matched >= kLeastOfAll &&
                      found.contradicted <= kMostContradicted && found.rms_m <= kMostRms_m;
    const bool near = found.beside_rad <= kMostBeside_rad && found.beside_m <= kMostBeside_m;
    found.trusted = fits && near;
    found.sentence = fmt::format(
        "of the gripper that should be seen {:.0f} % is found to {:.2f} mm, least {:.0f} %; "
        "through {:.0f} % the camera looks, most {:.0f} %; {:.0f} % is hidden",
        100.0 * of_visible, kMmPerM * found.rms_m, 100.0 * kLeastMatched,
        100.0 * found.contradicted, 100.0 * kMostContradicted, 100.0 * found.hidden);
    if (!near) {
        found.sentence += fmt::format(
            "; it would be {:.2f} deg and {:.1f} mm from where the robot says, most "
            "{:.1f} deg and {:.0f} mm",
            deg_from_rad(found.beside_rad), kMmPerM * found.beside_m, deg_from_rad(kMostBeside_rad),
            kMmPerM * kMostBeside_m);
    }
    if (found.trusted && found.observability < kLeastObservability) {
        found.sentence += "; its shape does not show the turn, which is the robot's";
    }
}

/// The surfaces did not verify a pose. Where they do not speak against the robot's, that is taken.
void fall_back(const GripperTemplate& gripper, const Seen& seen, const Pose& T_start,
               GripperMatch& found) {
    const auto part = make_surface(template_front(gripper.thin, T_start, seen.viewpoint()));
    if (!part) return;
    const Shares there = shares_at(*part, seen, Pose::Identity(), kRoughlyFound_m);
    if (there.found() < kLeastAtRobots || there.matched < kLeastOfAll ||
        there.contradicted > kMostContradicted) {
        return;
    }
    found.T_camera_gripper = T_start;
    found.as_robot_says = true;
    found.sentence += "; the robot's pose is used, not verified";
}

std::optional<DepthMap> depth_map(const Surface& scene) {
    return scene.viewpoint ? std::optional<DepthMap>(std::in_place, scene) : std::nullopt;
}

void conclude(const GripperTemplate& gripper, const Seen& seen, const std::optional<Pose>& T_start,
              GripperMatch& found) {
    if (T_start) compare_with_start(gripper, *T_start, found);
    judge(found);
    if (T_start && !found.trusted) fall_back(gripper, seen, *T_start, found);
}

}  // namespace

std::optional<Pose> expected_pose(const GripperTemplate& gripper,
                                  std::optional<double> joint6_rad) {
    if (!gripper.joint6_rad || !joint6_rad) return std::nullopt;
    return turn_about(gripper.axis, *joint6_rad - *gripper.joint6_rad);
}

GripperMatch match_gripper(const GripperTemplate& gripper, const Surface& scene,
                           const std::optional<Pose>& T_start) {
    const auto map = depth_map(scene);
    const Seen seen{scene, map ? &*map : nullptr};
    GripperMatch found;
    found.searched = !T_start;
    std::optional<Pose> start = T_start;
    if (!start) {
        const auto turned =
            best_of(gripper, seen, starts_all_around(gripper), {kSearchGate_m, kMiddleGate_m});
        if (turned) start = turned->T_camera_gripper;
    }
    std::optional<Settled> settled;
    if (start) {
        settled =
            best_of(gripper, seen, starts_near(gripper, *start), {kFirstGate_m, kMiddleGate_m});
    }
    if (settled) {
        found.T_camera_gripper = settled->T_camera_gripper;
        finish(gripper, scene, seen, found);
    }
    conclude(gripper, seen, T_start, found);
    return found;
}

GripperMatch match_again(const GripperTemplate& gripper, const Surface& own, const Surface& scene,
                         const std::optional<Pose>& T_start, const GripperMatch& before) {
    const auto map = depth_map(scene);
    const Seen seen{scene, map ? &*map : nullptr};
    GripperMatch found;
    found.searched = before.searched;
    found.T_camera_gripper = before.T_camera_gripper;
    finish(gripper, own, seen, found);
    conclude(gripper, seen, T_start, found);
    return found;
}

}  // namespace gripscan
