// Joint angles that bring the tool of a FANUC LR Mate 200iC/5L to a pose: all of them, in closed
// form, because the wrist's three axes meet in one point.
#pragma once

#include <string>
#include <vector>

#include "core/robot/kinematics.h"

namespace gripscan {

/// One way of reaching a pose.
struct ArmSolution {
    JointAngles joints_rad{};  ///< FANUC convention, as everywhere
    bool front = true;         ///< the arm reaches forward, not over its back
    bool elbow_up = true;
    bool wrist_positive = false;  ///< sign of joint 5: tells the two ways of the wrist apart
    /// Empty: within all ranges. Else which joint is beyond its range and by how much.
    std::string obstacle;
};

/// Every solution, with and without obstacles, for tool0 at T_world_tool. Joints 4 and 6 come with
/// all full turns that their ranges allow. Where joint 5 is straight, only the sum of joints 4 and
/// 6 is given; joint 4 is then that of `near`. Empty: the wrist's centre is out of reach.
[[nodiscard]] std::vector<ArmSolution> inverse_kinematics(const Pose& T_world_tool,
                                                          const JointAngles& near_rad = {});

/// Whether and how the arm gets there.
struct Reachability {
    bool reachable = false;
    JointAngles joints_rad{};            ///< the solution nearest to where the arm is
    std::vector<ArmSolution> solutions;  ///< within all ranges, nearest first
    std::string sentence;                ///< says what is in the way, or how it gets there
};

/// Nearest: the smallest largest motion of a joint from near_rad.
[[nodiscard]] Reachability reachability(const Pose& T_world_tool, const JointAngles& near_rad);

}  // namespace gripscan
