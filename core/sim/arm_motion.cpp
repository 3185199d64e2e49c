#include "core/sim/arm_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/seeded_random.h"
#include "core/base/units.h"

namespace gripscan::sim {
namespace {

MotionProfile standing(double angle_rad) {
    return {angle_rad, angle_rad, rad_from_deg(ArmMotion::kFullSpeed_deg_s),
            rad_from_deg(ArmMotion::kAcceleration_deg_s2)};
}

}  // namespace

ArmMotion::ArmMotion(const JointAngles& joints_rad, std::uint64_t seed, StepFaults faults)
    : joints_rad_(joints_rad),
      seed_(seed),
      faults_(std::move(faults)),
      travel_(standing(joints_rad[5])) {}

void ArmMotion::turn_joint6(double angle_rad, double speed_percent, double now_s) {
    const double from_rad = travel_.position_rad(now_s - began_s_);
    travel_ = standing(angle_rad);
    travel_.from_rad = from_rad;
    travel_.speed_rad_s *= speed_percent / 100.0;
    began_s_ = now_s;
    if (angle_rad != from_rad) rising_ = angle_rad > from_rad;
    // A tenth of the full speed shakes as much as more does.
    const double speed = travel_.top_speed_rad_s() / rad_from_deg(kFullSpeed_deg_s / 10.0);
    tremble_rad_ = rad_from_deg(kTremble_deg) * std::min(1.0, speed);
}

void ArmMotion::stop(double now_s) {
    if (now_s - began_s_ >= travel_.duration_s()) return;
    travel_ = standing(travel_.position_rad(now_s - began_s_));
    began_s_ = now_s;
}

ArmMotion::Errors ArmMotion::errors_at(double angle_rad) const {
    SeededRandom random(SeededRandom(seed_ ^ number_of_angle(angle_rad)).next());
    const double stop = random.normal();
    return {rad_from_deg(kRepeatability_deg) * stop, rad_from_deg(kEncoder_deg) * random.normal()};
}

double ArmMotion::tremble_rad(double since_end_s) const {
    if (since_end_s < 0.0 || since_end_s >= kSettle_s) return 0.0;
    constexpr double kFrequency_hz = 22.0;
    constexpr double kDecay_s = 0.08;
    const double left = 1.0 - since_end_s / kSettle_s;
    return tremble_rad_ * left * left * std::exp(-since_end_s / kDecay_s) *
           std::sin(2.0 * std::numbers::pi * kFrequency_hz * since_end_s);
}

ArmState ArmMotion::at(double now_s) const {
    const double since_s = now_s - began_s_;
    const double end_s = travel_.duration_s();
    ArmState state{joints_rad_, joints_rad_, travel_.position_rad(since_s), since_s < end_s};
    const double angle_rad = state.joint6_rad;
    Errors errors = errors_at(travel_.to_rad);
    if (state.moving) {
        const Errors before = errors_at(travel_.from_rad);
        const double gone = since_s / end_s;
        errors.stop_rad = std::lerp(before.stop_rad, errors.stop_rad, gone);
        errors.encoder_rad = std::lerp(before.encoder_rad, errors.encoder_rad, gone);
    }
    const double stopped_rad = angle_rad + errors.stop_rad;
    state.encoder_rad[5] = stopped_rad + errors.encoder_rad;
    state.true_rad[5] = faults_.true_joint6_rad(angle_rad, rising_) + errors.stop_rad +
                        tremble_rad(since_s - end_s);
    return state;
}

}  // namespace gripscan::sim
