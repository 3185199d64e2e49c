// Registration of two clouds without being told anything about the motion between them.
#pragma once

#include <cstdint>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/geometry/pose.h"
#include "core/registration/verdict.h"

namespace gripscan {

struct AlignSettings {
    std::uint64_t seed = 1;  ///< of the perturbed starts
    /// Cone of rotations (about any axis) the perturbed starts are drawn from. Identity is always
    /// one of them.
    double start_cone_rad = 0.7;
    int starts = 12;
    /// Look at all rotations too even if a start in the cone convinces: for clouds that may have
    /// been turned by any angle.
    bool all_rotations = false;
    std::size_t coarse_points = 700;  ///< points of a start
    std::size_t fine_points = 12000;  ///< points of the final estimate
    TurnLimits limits;
};

/// What is known about the motion that maps the source onto the target.
struct Alignment {
    Pose T_target_source = Pose::Identity();
    bool found = false;                               ///< false: T is meaningless
    double angle_rad = 0.0;                           ///< rotation angle of T, ≥ 0
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of the rotation, right-hand rule
    double overlap = 0.0;  ///< share of the source that should be visible in the target and is
    double rms_m = 0.0;    ///< of the inliers, along the normal
    double median_m = 0.0;
    double p90_m = 0.0;
    double misfit = 0.0;  ///< size of all residuals over that predicted from the noise
    /// Covariance of [ω; v] (rad, m) about the centroid of the matched points, target frame.
    Matrix6d covariance = Matrix6d::Zero();
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    double sigma_angle_rad = 0.0;  ///< predicted, about `axis`
    /// 0: the surface looks the same after a turn about `axis`; 1: as tied down as a surface of
    /// this size can be.
    double observability = 0.0;
    bool starts_agree = false;
    Verdict verdict = Verdict::kReject;
    Cause cause = Cause::kNotConverged;
    std::string sentence;
};

/// Our turn registration: coarse search from identity and seeded perturbed starts, then a robust
/// symmetric point-to-plane estimate weighted with the stereo noise.
/// Errors: a cloud with too few points. Failing to align is no error but a verdict.
[[nodiscard]] Result<Alignment> align(const Cloud& source, const Cloud& target,
                                      const AlignSettings& settings, const Progress& progress,
                                      const ForEach& for_each);

/// The paper's method: PCL point-to-point ICP from the identity.
struct PaperIcpSettings {
    double max_correspondence_m = 0.05;
    int iterations = 10;
    double transformation_epsilon = 1e-8;
    double voxel_m = 0.0;  ///< thinning before ICP; 0: none
};
[[nodiscard]] Result<Alignment> align_paper_icp(const Cloud& source, const Cloud& target,
                                                const PaperIcpSettings& settings);

}  // namespace gripscan
