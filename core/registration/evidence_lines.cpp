#include "core/registration/evidence_lines.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/registration/diagnosis.h"
#include "core/registration/grip_slip.h"
#include "core/registration/turn_check.h"

namespace gripscan {
namespace {

double mm2(double m2) {
    return kMmPerM * kMmPerM * m2;
}

class Lines {
  public:
    template <typename... Args>
    void add(std::string what, bool exceeded, std::string limit, fmt::format_string<Args...> text,
             Args&&... args) {
        lines_.push_back({std::move(what), fmt::format(text, std::forward<Args>(args)...),
                          std::move(limit), exceeded});
    }
    void unknown(std::string what, std::string limit) {
        lines_.push_back({std::move(what), "not known", std::move(limit), false});
    }
    [[nodiscard]] std::vector<EvidenceLine> take() { return std::move(lines_); }

  private:
    std::vector<EvidenceLine> lines_;
};

void add_numbers(Lines& lines, const TurnStep& step, const TurnLimits& limits) {
    const double angle_rad = angle_limit_rad(step, limits);
    const std::string angle_text = fmt::format("{:.3f} deg", deg_from_rad(angle_rad));
    if (step.error_rad) {
        lines.add("angle", std::abs(*step.error_rad) > angle_rad, angle_text, "{:+.3f} deg",
                  deg_from_rad(*step.error_rad));
    } else {
        lines.unknown("angle", angle_text);
    }
    const std::string overlap_text = fmt::format("at least {:.0f} %", 100.0 * limits.overlap);
    if (step.overlap) {
        lines.add("overlap", *step.overlap < limits.overlap, overlap_text, "{:.0f} %",
                  100.0 * *step.overlap);
    } else {
        lines.unknown("overlap", overlap_text);
    }
    if (step.tilt_rad) {
        lines.add("tilt of the axis", *step.tilt_rad > limits.tilt_rad,
                  fmt::format("{:.2f} deg", deg_from_rad(limits.tilt_rad)), "{:.2f} deg",
                  deg_from_rad(*step.tilt_rad));
    }
    if (step.slip_m) {
        lines.add("slip along the axis", std::abs(*step.slip_m) > limits.slip_m,
                  fmt::format("{:.2f} mm", kMmPerM * limits.slip_m), "{:+.2f} mm",
                  kMmPerM * *step.slip_m);
    }
    if (step.grip_slip) {
        const GripSlip& slip = *step.grip_slip;
        lines.add("slip in the gripper", slipped(slip, limits),
                  fmt::format("{:.2f} mm, {:.2f} deg", kMmPerM * grip_shift_limit_m(slip, limits),
                              deg_from_rad(grip_angle_limit_rad(slip, limits))),
                  "{:.2f} ± {:.2f} mm, {:.2f} ± {:.2f} deg", kMmPerM * slip.shift_m,
                  kMmPerM * slip.sigma_shift_m, deg_from_rad(slip.angle_rad),
                  deg_from_rad(slip.sigma_angle_rad));
    }
}

void add_observability(Lines& lines, const TurnStep& step, const StepEvidence& evidence) {
    if (step.observability) {
        lines.add("observability", *step.observability < evidence.least_observability,
                  fmt::format("at least {:.2f}", evidence.least_observability), "{:.2f}",
                  *step.observability);
    }
    if (evidence.misfit) {
        lines.add("misfit under the lock", *evidence.misfit > kMostMisfit,
                  fmt::format("{:.1f} times the noise", kMostMisfit), "{:.1f} times the noise",
                  *evidence.misfit);
    } else if (evidence.found) {
        lines.add("starts", !evidence.starts_agree, "one answer", "{}",
                  evidence.starts_agree ? "one answer" : "several answers");
    }
}

void add_joints(Lines& lines, const StepEvidence& evidence) {
    const std::string limit = fmt::format("{:.2f} deg", deg_from_rad(kJointStill_rad));
    lines.add("joint 6 in the exposure", evidence.joint6_moved_rad > kJointStill_rad, limit,
              "{:.3f} deg", deg_from_rad(evidence.joint6_moved_rad));
    lines.add("other joints", evidence.other_joints_moved_rad > kJointStill_rad, limit,
              "{:.3f} deg", deg_from_rad(evidence.other_joints_moved_rad));
}

void add_witnesses(Lines& lines, const TurnStep& step, const StepEvidence& evidence,
                   const TurnLimits& limits) {
    const std::string camera_limit = fmt::format("{:.2f} px", kMostCameraShift_px);
    if (evidence.camera_shift) {
        const CameraShift& shift = *evidence.camera_shift;
        lines.add("background", camera_moved(evidence), camera_limit,
                  "{:.2f} px in {} places, {:.0f} % agree", shift.shift_px, shift.patches,
                  100.0 * shift.agreeing);
    } else {
        lines.unknown("background", camera_limit);
    }
    if (evidence.as_reported) {
        lines.add("shared if the robot is right",
                  step.cause == Cause::kOverlap && step_too_large(evidence, limits),
                  fmt::format("at least {:.0f} %", 100.0 * limits.overlap),
                  "{:.0f} %, and {:.0f} % floats", 100.0 * evidence.as_reported->matched,
                  100.0 * evidence.as_reported->contradicted);
    }
    const std::string area_limit = fmt::format("{:.0f} mm2", mm2(evidence.unexplained_limit_m2));
    const double area_m2 = evidence.unexplained ? evidence.unexplained->area_m2 : 0.0;
    lines.add("not explained", much_unexplained(evidence), area_limit, "{:.0f} mm2", mm2(area_m2));
    if (evidence.image_fault) {
        lines.add("images", true, "as the other captures", "capture {}: {}",
                  evidence.image_fault_in, evidence.image_fault->sentence);
    }
}

}  // namespace

std::vector<EvidenceLine> evidence_lines(const TurnStep& step, const StepEvidence& evidence,
                                         const TurnLimits& limits) {
    Lines lines;
    add_numbers(lines, step, limits);
    add_observability(lines, step, evidence);
    add_joints(lines, evidence);
    add_witnesses(lines, step, evidence, limits);
    return lines.take();
}

}  // namespace gripscan
