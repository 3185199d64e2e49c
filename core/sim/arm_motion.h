// The simulated arm in time: joint 6 travels, comes to rest and then stands exactly; encoders and
// true joints differ by errors that belong to the angle, and by what faults do.
#pragma once

#include <cstdint>

#include "core/robot/robot_link.h"
#include "core/sim/motion_profile.h"
#include "core/sim/step_faults.h"

namespace gripscan::sim {

/// Where the arm is at some time. The true joints stay with the renderer.
struct ArmState {
    JointAngles true_rad{};
    JointAngles encoder_rad{};
    double joint6_rad = 0.0;  ///< as its controller drives it, without any error
    bool moving = false;      ///< travelling; what still trembles does not travel
};

/// Times are seconds of one clock that does not go back. Not for several threads at once.
class ArmMotion {
  public:
    /// Standard deviations of joint 6: where it stops, and what its encoder reads.
    static constexpr double kRepeatability_deg = 0.005;
    static constexpr double kEncoder_deg = 0.001;
    static constexpr double kFullSpeed_deg_s = 720.0;
    static constexpr double kAcceleration_deg_s2 = 1800.0;
    /// After the end of a travel the true joint trembles: so much at first, nothing after so long.
    static constexpr double kTremble_deg = 0.04;
    static constexpr double kSettle_s = 0.25;

    /// Stands at these joints.
    ArmMotion(const JointAngles& joints_rad, std::uint64_t seed, StepFaults faults = {});

    void turn_joint6(double angle_rad, double speed_percent, double now_s);
    /// Where it is, there it stays.
    void stop(double now_s);

    /// Seconds from the start of the present travel to its end.
    [[nodiscard]] double duration_s() const { return travel_.duration_s(); }
    [[nodiscard]] double began_s() const { return began_s_; }

    /// A standing arm is a function of the angle, the side it came from and the seed.
    [[nodiscard]] ArmState at(double now_s) const;

  private:
    struct Errors {
        double stop_rad = 0.0;
        double encoder_rad = 0.0;
    };
    [[nodiscard]] Errors errors_at(double angle_rad) const;
    [[nodiscard]] double tremble_rad(double since_end_s) const;

    JointAngles joints_rad_;
    std::uint64_t seed_;
    StepFaults faults_;
    MotionProfile travel_;
    double began_s_ = 0.0;
    double tremble_rad_ = 0.0;  ///< at the end of this travel
    bool rising_ = true;
};

}  // namespace gripscan::sim
