// The linear system of the joint solution: what pairs of views and the robot say about small
// corrections of all poses, of the axis and of the robot's scale and offset.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/axis.h"
#include "core/geometry/pose.h"
#include "core/registration/point_to_plane.h"

namespace gripscan {

/// Adjoint of T for motions [ω; v] about `centre`: moving first by u and then by T is moving first
/// by T and then by Ad · u.
[[nodiscard]] Matrix6d adjoint_about(const Pose& T, const Eigen::Vector3d& centre);

/// The small motion [ω; v] about the centre that T is.
[[nodiscard]] Vector6d motion_of(const Pose& T, const Eigen::Vector3d& centre);

/// Unknowns: 6 a view after the first (motion about the centre, camera frame), then the axis (two
/// tilts, two shifts, in the directions of `across`), the robot's scale and offset, and the scans'
/// own scale.
class JointSystem {
  public:
    static constexpr int kGlobals = 7;
    enum Global { kRobotScale = 4, kRobotOffset = 5, kScanScale = 6 };

    JointSystem(std::size_t views, const Axis& axis, const Eigen::Vector3d& centre);

    /// Surface of view `from` matched onto that of `to`, which are angle_rad apart: the scans see
    /// scan_scale times the true turn. Weight divides out what pairs have in common.
    void add_pair(std::size_t from, std::size_t to, const Pose& T_to_from, double angle_rad,
                  double scan_scale, const NormalEquations& sums, double weight);

    /// What the robot and the fixed axis say about view k: its pose ought to be a turn by
    /// scale · angle + offset. Information along and across the axis.
    struct Prior {
        double angle_rad = 0.0;  ///< reported
        double sigma_angle_rad = 0.0;
        double sigma_off_axis_rad = 0.0;
        double sigma_shift_m = 0.0;
    };
    void add_prior(std::size_t view, const Pose& T_view_first, double scale, double offset_rad,
                   const Prior& prior);
    /// What is known beforehand of a correction.
    void add_global_prior(Global index, double wanted_correction, double sigma);

    /// Solves; false if nothing can be solved.
    bool solve();
    [[nodiscard]] Pose correction(std::size_t view) const;
    [[nodiscard]] Eigen::Matrix<double, kGlobals, 1> global_corrections() const;
    /// Standard deviations of the globals.
    [[nodiscard]] Eigen::Matrix<double, kGlobals, 1> global_sigmas() const;
    /// The axis after the correction.
    [[nodiscard]] Axis corrected_axis() const;

  private:
    /// Motion about the centre that one rad of turn about the axis is.
    [[nodiscard]] Vector6d unit_turn() const;
    [[nodiscard]] int column(std::size_t view) const { return 6 * (static_cast<int>(view) - 1); }

    Axis axis_;
    Eigen::Vector3d centre_;
    Eigen::Matrix<double, 3, 2> across_;
    int globals_ = 0;
    Eigen::MatrixXd H_;
    Eigen::VectorXd g_;
    Eigen::VectorXd x_;
};

}  // namespace gripscan
