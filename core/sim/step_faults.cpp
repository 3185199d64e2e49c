#include "core/sim/step_faults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/seeded_random.h"
#include "core/base/units.h"

namespace gripscan::sim {
namespace {

/// A step has begun when more than this part of it is turned: angles are met nearly.
constexpr double kBegun = 0.25;
constexpr double kLooseShift_m = 0.001;
constexpr double kBumpTurn_rad_per_m = rad_from_deg(100.0);

Eigen::Vector3d random_direction(SeededRandom& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// A tilt about the flange's face, up to a fifth more or less than asked for, and a shift.
Pose loose_pose(double tilt_rad, SeededRandom random) {
    const double towards = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Eigen::Vector3d axis(std::cos(towards), std::sin(towards), 0.0);
    Pose T = Pose::Identity();
    T.linear() = rotation_from_vector(tilt_rad * random.uniform(0.8, 1.2) * axis);
    const double shift_m = random.uniform(0.0, kLooseShift_m);
    T.translation() = shift_m * random_direction(random);
    return T;
}

}  // namespace

std::uint64_t number_of_angle(double angle_rad) {
    constexpr double kSameAngle_rad = 1e-7;
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(std::llround(angle_rad / kSameAngle_rad)));
}

StepFaults::StepFaults(const std::vector<Fault>& faults, double start_rad, double step_rad,
                       std::uint64_t seed)
    : faults_(faults), start_rad_(start_rad), step_rad_(step_rad), seed_(seed) {}

const Fault* StepFaults::planned(FaultKind kind) const {
    const auto fault = std::find_if(faults_.begin(), faults_.end(),
                                    [&](const Fault& f) { return f.kind == kind; });
    return fault == faults_.end() ? nullptr : &*fault;
}

double StepFaults::step_number(double angle_rad) const {
    return (angle_rad - start_rad_) / step_rad_;
}

const Fault* StepFaults::active(FaultKind kind, double angle_rad) const {
    const Fault* fault = planned(kind);
    const bool begun = fault != nullptr && step_number(angle_rad) > fault->step - 1 + kBegun;
    return begun ? fault : nullptr;
}

double StepFaults::onset_rad(const Fault& fault) const {
    return start_rad_ + std::max(0, fault.step - 1) * step_rad_;
}

double StepFaults::true_joint6_rad(double angle_rad, bool rising) const {
    double true_rad = angle_rad;
    if (const Fault* ratio = planned(FaultKind::kRatio)) {
        const double since_rad = std::max(0.0, true_rad - onset_rad(*ratio));
        true_rad += (ratio->amount - 1.0) * since_rad;
    }
    if (const Fault* backlash = planned(FaultKind::kBacklash)) {
        const bool fallen = active(FaultKind::kBacklash, angle_rad) != nullptr;
        if (fallen == rising) true_rad -= rad_from_deg(backlash->amount);
    }
    if (const Fault* sign = planned(FaultKind::kSign)) {
        true_rad -= 2.0 * std::max(0.0, true_rad - onset_rad(*sign));
    }
    return true_rad;
}

Pose StepFaults::T_tool_part(double angle_rad) const {
    Pose T = Pose::Identity();
    if (const Fault* slip = active(FaultKind::kSlip, angle_rad)) {
        T.translation().z() = slip->amount / kMmPerM;
    }
    if (const Fault* loose = active(FaultKind::kLoose, angle_rad)) {
        const SeededRandom random(SeededRandom(seed_ ^ number_of_angle(angle_rad)).next());
        T = loose_pose(rad_from_deg(loose->amount), random) * T;
    }
    return T;
}

Pose StepFaults::T_grasp_object(double angle_rad) const {
    Pose T = Pose::Identity();
    if (const Fault* slip = active(FaultKind::kObjectSlip, angle_rad)) {
        SeededRandom random(SeededRandom(seed_ + 2).next());
        const double towards = random.uniform(0.0, 2.0 * std::numbers::pi);
        T.translation() =
            slip->amount / kMmPerM * Eigen::Vector3d(0.0, std::cos(towards), std::sin(towards));
    }
    if (const Fault* twist = active(FaultKind::kObjectTwist, angle_rad)) {
        T.linear() = rotation_from_vector(rad_from_deg(twist->amount) * Eigen::Vector3d::UnitX());
    }
    return T;
}

Pose StepFaults::T_camera_moved(double angle_rad) const {
    Pose T = Pose::Identity();
    if (const Fault* bump = active(FaultKind::kBump, angle_rad)) {
        const double shift_m = bump->amount / kMmPerM;
        SeededRandom random(SeededRandom(seed_ + 1).next());
        T.translation() = shift_m * random_direction(random);
        T.linear() = rotation_from_vector(kBumpTurn_rad_per_m * shift_m * random_direction(random));
    }
    return T;
}

double StepFaults::intruder_m(double angle_rad) const {
    const Fault* intruder = active(FaultKind::kIntruder, angle_rad);
    return intruder == nullptr ? 0.0 : intruder->amount / kMmPerM;
}

double StepFaults::tool_m(double angle_rad) const {
    const Fault* tool = active(FaultKind::kTool, angle_rad);
    return tool == nullptr ? 0.0 : tool->amount / kMmPerM;
}

Eigen::Vector3d StepFaults::surroundings_shift_m(double angle_rad) const {
    const Fault* shift = active(FaultKind::kShift, angle_rad);
    if (shift == nullptr) return Eigen::Vector3d::Zero();
    SeededRandom random(SeededRandom(seed_ + 2).next());
    return shift->amount / kMmPerM * random_direction(random);
}

double StepFaults::defocus_px(double angle_rad) const {
    const Fault* defocus = active(FaultKind::kDefocus, angle_rad);
    return defocus == nullptr ? 0.0 : defocus->amount;
}

double StepFaults::glare_px(double angle_rad, int attempt) const {
    const Fault* glare = planned(FaultKind::kGlare);
    if (glare == nullptr || attempt != 1) return 0.0;
    const bool there = std::abs(step_number(angle_rad) - glare->step) < kBegun;
    return there ? glare->amount : 0.0;
}

double StepFaults::planned_intruder_m() const {
    const Fault* intruder = planned(FaultKind::kIntruder);
    return intruder == nullptr ? 0.0 : intruder->amount / kMmPerM;
}

double StepFaults::planned_tool_m() const {
    const Fault* tool = planned(FaultKind::kTool);
    return tool == nullptr ? 0.0 : tool->amount / kMmPerM;
}

double StepFaults::slack_m(double reach_m) const {
    double slack_m = 0.0;
    if (const Fault* slip = planned(FaultKind::kSlip)) slack_m += std::abs(slip->amount) / kMmPerM;
    if (const Fault* loose = planned(FaultKind::kLoose)) {
        slack_m += kLooseShift_m + 1.2 * rad_from_deg(loose->amount) * reach_m;
    }
    if (const Fault* slip = planned(FaultKind::kObjectSlip)) {
        slack_m += std::abs(slip->amount) / kMmPerM;
    }
    if (const Fault* twist = planned(FaultKind::kObjectTwist)) {
        slack_m += rad_from_deg(std::abs(twist->amount)) * reach_m;
    }
    return slack_m;
}

}  // namespace gripscan::sim
