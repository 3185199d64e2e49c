// What faults do to arm, gripper and camera: functions of the angle that joint 6 was told to stand
// at, never of what happened before, so that a resumed run meets them as an undisturbed one does.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/pose.h"
#include "core/sim/fault_plan.h"

namespace gripscan::sim {

class StepFaults {
  public:
    StepFaults() = default;
    /// `step_rad` is the nominal step by which the faults' numbers count, from `start_rad` on.
    StepFaults(const std::vector<Fault>& faults, double start_rad, double step_rad,
               std::uint64_t seed);

    /// Where joint 6 truly stands when its encoder says `angle_rad`; `rising`: it came from below.
    [[nodiscard]] double true_joint6_rad(double angle_rad, bool rising) const;
    /// Where what is mounted stands in the flange's tool0; the identity: as it was mounted.
    [[nodiscard]] Pose T_tool_part(double angle_rad) const;
    /// Where what is held stands in the frame of the grasp; the identity: as it was gripped. It
    /// slides across the fingers' stroke x, which holds it, and turns about it.
    [[nodiscard]] Pose T_grasp_object(double angle_rad) const;
    /// Where the camera stands now, in the frame it had at the start.
    [[nodiscard]] Pose T_camera_moved(double angle_rad) const;
    /// Thickness of a strange thing in the registration area, m; 0: none.
    [[nodiscard]] double intruder_m(double angle_rad) const;
    /// Length of a tool left in the registration area, m; 0: none.
    [[nodiscard]] double tool_m(double angle_rad) const;
    /// By how much everything that does not belong to the arm stands elsewhere, in WORLD.
    [[nodiscard]] Eigen::Vector3d surroundings_shift_m(double angle_rad) const;
    /// Standard deviation of the additional blur; 0: none.
    [[nodiscard]] double defocus_px(double angle_rad) const;
    /// Radius of the saturated spot; 0: none.
    [[nodiscard]] double glare_px(double angle_rad, int attempt) const;

    /// Thickness of the thing that comes at some angle; 0: none comes.
    [[nodiscard]] double planned_intruder_m() const;
    /// Length of the tool that is left at some angle; 0: none is.
    [[nodiscard]] double planned_tool_m() const;
    /// How far a point of gripper or object, `reach_m` from the flange, may be moved by faults.
    [[nodiscard]] double slack_m(double reach_m) const;

  private:
    [[nodiscard]] const Fault* planned(FaultKind kind) const;
    [[nodiscard]] double step_number(double angle_rad) const;
    /// The fault, if the step that it names has begun at that angle.
    [[nodiscard]] const Fault* active(FaultKind kind, double angle_rad) const;
    /// Turn since the start of the fault's step, and the angle there.
    [[nodiscard]] double onset_rad(const Fault& fault) const;

    std::vector<Fault> faults_;
    double start_rad_ = 0.0;
    double step_rad_ = 1.0;
    std::uint64_t seed_ = 0;
};

/// The number by which random errors belong to an angle: equal for angles that differ by no more
/// than rounding.
[[nodiscard]] std::uint64_t number_of_angle(double angle_rad);

}  // namespace gripscan::sim
