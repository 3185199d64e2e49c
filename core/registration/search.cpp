#include "core/registration/search.h"

#include <algorithm>
#include <cmath>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/registration/point_to_plane.h"

namespace gripscan {
namespace {

/// Poses closer than this are the same minimum: rotation, and shift as a share of the radius.
constexpr double kSameRotation_rad = 1.5 * kRadPerDeg;
constexpr double kSameShift = 0.04;

bool same_minimum(const Pose& a, const Pose& b, const Surface& source) {
    const Pose d = a.inverse() * b;
    return rotation_angle_rad(d.linear()) < kSameRotation_rad &&
           (d * source.centre_m - source.centre_m).norm() < kSameShift * source.radius_m;
}

/// The rotation about the middle of the source, then middle onto middle; the identity is kept as
/// it is, for it says "nothing moved" and not "the middles agree".
Pose start_pose(const Eigen::Matrix3d& R, const Surface& source, const Surface& target,
                bool identity) {
    Pose T = Pose::Identity();
    if (identity) return T;
    T.linear() = R;
    T.translation() = target.centre_m - R * source.centre_m;
    return T;
}

std::vector<Candidate> merge_minima(std::vector<Candidate> all, const Surface& source) {
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
        return a.agreement.score > b.agreement.score;
    });
    std::vector<Candidate> distinct;
    for (const Candidate& candidate : all) {
        const auto twin = std::find_if(distinct.begin(), distinct.end(), [&](const Candidate& d) {
            return same_minimum(d.T_target_source, candidate.T_target_source, source);
        });
        if (twin == distinct.end()) {
            distinct.push_back(candidate);
        } else {
            twin->starts += candidate.starts;
        }
    }
    return distinct;
}

}  // namespace

std::vector<Eigen::Matrix3d> start_rotations(int count, double cone_rad, std::uint64_t seed) {
    std::vector<Eigen::Matrix3d> rotations{Eigen::Matrix3d::Identity()};
    SeededRandom random(seed);
    while (static_cast<int>(rotations.size()) < count) {
        const Eigen::Vector3d v(random.uniform(-1, 1), random.uniform(-1, 1),
                                random.uniform(-1, 1));
        if (v.squaredNorm() > 1.0) continue;
        rotations.push_back(rotation_from_vector(cone_rad * v));
    }
    return rotations;
}

std::vector<Candidate> search(const Surface& source, const Surface& target,
                              const DepthMap* source_map, const DepthMap* target_map,
                              const AlignSettings& settings, double cone_rad, int starts,
                              const ForEach& for_each) {
    const auto rotations = start_rotations(starts, cone_rad, settings.seed);
    const auto source_sample = spread_sample(source, settings.coarse_points);
    const auto target_sample = spread_sample(target, settings.coarse_points);
    const double radius_m = 0.5 * (source.radius_m + target.radius_m);
    // Wide enough to pull from a start some tens of degrees off, narrow enough in the end to tell
    // minima apart.
    RefineSettings refine_settings;
    refine_settings.first_gate_m = 0.35 * radius_m;
    refine_settings.last_gate_m =
        std::max(0.05 * radius_m, 3.0 * std::max(source.spacing_m, target.spacing_m));
    refine_settings.shrink = 0.85;
    refine_settings.iterations = 25;
    refine_settings.tolerance = 1e-4;
    refine_settings.min_normal_cos = 0.6F;
    std::vector<Candidate> ends(rotations.size());
    for_each(rotations.size(), [&](std::size_t i) {
        const Pose start = start_pose(rotations[i], source, target, i == 0);
        Candidate& end = ends[i];
        end.starts = 1;
        end.T_target_source = refine(source, target, {source_sample, {}}, start, refine_settings);
        end.agreement =
            agreement(source, target, source_map, target_map, source_sample, target_sample,
                      end.T_target_source, 0.5 * refine_settings.last_gate_m);
    });
    return merge_minima(std::move(ends), source);
}

}  // namespace gripscan
