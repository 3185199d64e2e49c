// Robust symmetric point-to-plane registration from a given start: the inner loop of everything
// that aligns two surfaces.
#pragma once

#include <span>

#include "core/geometry/pose.h"
#include "core/registration/surface.h"

namespace gripscan {

/// A pair of points taken for the same spot of the part.
struct Match {
    std::uint32_t source = 0;
    std::uint32_t target = 0;
    float residual_m = 0.0F;  ///< along the common normal, target frame
    float sigma_m = 0.0F;     ///< predicted from both points' noise
    float weight = 0.0F;      ///< robust weight in [0, 1]; 0: taken for an outlier
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< common normal, target frame
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();  ///< between the two points, target frame, m
};

struct MatchingSettings {
    double gate_m = 0.01;         ///< longest distance of a pair
    float min_normal_cos = 0.7F;  ///< cosine of the largest angle between the normals
    bool skip_rims = true;        ///< a match with a silhouette is no match
};

/// Which points of each side look for a partner on the other. Both directions make the estimate
/// the same, inverted, when source and target are exchanged.
struct Samples {
    std::span<const std::uint32_t> source;
    std::span<const std::uint32_t> target;
};

/// Pairs at the pose T, with residuals and predicted sigmas; weights are those of Tukey's biweight
/// (Beaton and Tukey 1974) at a scale from the median of |residual/sigma|, never below 1.
[[nodiscard]] std::vector<Match> match(const Surface& source, const Surface& target,
                                       const Samples& samples, const Pose& T_target_source,
                                       const MatchingSettings& settings);

/// Gauss–Newton sums over the matches: motion [ω; v] of the source about `centre`, target frame.
struct NormalEquations {
    Matrix6d H = Matrix6d::Zero();
    Vector6d g = Vector6d::Zero();
    double weight = 0.0;  ///< Σ robust weights
};
[[nodiscard]] NormalEquations normal_equations(const std::vector<Match>& matches,
                                               const Eigen::Vector3d& centre);
/// [(m − c) × n; n]: how the residual of a match answers to a motion about the centre.
[[nodiscard]] Vector6d jacobian(const Match& match, const Eigen::Vector3d& centre);

struct RefineSettings {
    double first_gate_m = 0.03;
    double last_gate_m = 0.003;
    double shrink = 0.7;      ///< of the gate from one iteration to the next
    int iterations = 30;      ///< at most
    double tolerance = 1e-6;  ///< of the last motion, in rad and in radii
    float min_normal_cos = 0.7F;
};

/// Iterates match → solve → move, the gate narrowing (Rusinkiewicz 2019 for the symmetric
/// objective). Directions the surface does not tie down are left as they were in the start.
[[nodiscard]] Pose refine(const Surface& source, const Surface& target, const Samples& samples,
                          const Pose& start, const RefineSettings& settings);

}  // namespace gripscan
