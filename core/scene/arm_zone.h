// The room that the arm is known to fill: a capsule or two for each link, placed by the joints and
// the robot-camera alignment.
#pragma once

#include <vector>

#include "core/cloud/cloud.h"
#include "core/robot/kinematics.h"

namespace gripscan {

/// All points nearer than the radius to the line from a to b.
struct Capsule {
    Eigen::Vector3d a_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d b_m = Eigen::Vector3d::Zero();
    double radius_m = 0.0;

    [[nodiscard]] double distance_m(const Eigen::Vector3d& p_m) const;  ///< < 0: inside
};

class ArmZone {
  public:
    /// The margin is for an alignment that is off by some millimetres, hoses and noise.
    ArmZone(const JointAngles& joints_rad, const Pose& T_robot_camera, double margin_m = 0.015);

    /// In the camera frame. What lies before the flange's face is the tool's and never the last two
    /// links'.
    [[nodiscard]] bool contains(const Eigen::Vector3d& p_m) const;
    [[nodiscard]] std::vector<std::size_t> outside(const Cloud& scene,
                                                   const std::vector<std::size_t>& indices) const;
    /// For drawing, without the margin.
    [[nodiscard]] std::vector<Capsule> capsules() const;

  private:
    struct Placed {
        Capsule capsule;
        bool ends_at_flange = false;
    };
    std::vector<Placed> placed_;
    Eigen::Vector3d flange_m_;
    Eigen::Vector3d out_of_flange_;
    double margin_m_;
};

}  // namespace gripscan
