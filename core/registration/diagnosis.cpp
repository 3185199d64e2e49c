#include "core/registration/diagnosis.h"

#include <fmt/format.h>

#include "core/base/units.h"
#include "core/registration/grip_slip.h"
#include "core/registration/turn_check.h"

namespace gripscan {
namespace {

double mm2(double m2) {
    return kMmPerM * kMmPerM * m2;
}

void reject(TurnStep& step, Cause cause, std::string sentence) {
    step.verdict = Verdict::kReject;
    step.cause = cause;
    step.sentence = std::move(sentence);
}

std::string moved_camera_sentence(const CameraShift& shift) {
    return fmt::format(
        "the background moved by {:.2f} px between the captures ({} places, {:.0f} % agree), limit "
        "{:.2f} px: the camera or its mount was moved",
        shift.shift_px, shift.patches, 100.0 * shift.agreeing, kMostCameraShift_px);
}

std::string foreign_sentence(const StepEvidence& evidence) {
    const Unexplained& u = *evidence.unexplained;
    const Eigen::Vector3d mm = kMmPerM * u.centre_m;
    return fmt::format(
        "capture {} shows something in the registration area that does not turn with the part: "
        "{:.0f} mm2 of surface about ({:.0f}, {:.0f}, {:.0f}) mm, {:.0f} mm large, limit {:.0f} "
        "mm2{}",
        evidence.unexplained_in, mm2(u.area_m2), mm.x(), mm.y(), mm.z(), kMmPerM * u.size_m,
        mm2(evidence.unexplained_limit_m2),
        u.standing > 0.5 ? "; it stands there in the other capture too" : "");
}

/// Is what is not explained one thing beside a part that fits, rather than a part that does not?
bool one_thing(const StepEvidence& evidence) {
    return evidence.unexplained->other_area_m2 < evidence.unexplained->area_m2;
}

/// An alignment that decides nothing tells of no slip either.
bool slip_is_real(const TurnStep& step, const TurnLimits& limits) {
    const bool measured = step.cause != Cause::kNotConverged && step.cause != Cause::kSymmetry &&
                          step.cause != Cause::kTexture;
    return measured && step.grip_slip && slipped(*step.grip_slip, limits);
}

std::string slip_sentence(const GripSlip& slip, const TurnLimits& limits) {
    return fmt::format(
        "the part moved in the gripper by {:.2f} mm and {:.2f} deg, limits {:.2f} mm and {:.2f} "
        "deg",
        kMmPerM * slip.shift_m, deg_from_rad(slip.angle_rad),
        kMmPerM * grip_shift_limit_m(slip, limits),
        deg_from_rad(grip_angle_limit_rad(slip, limits)));
}

void name_bad_images(TurnStep& step, const StepEvidence& evidence) {
    const ImageFault& fault = *evidence.image_fault;
    const bool explained = step.cause == Cause::kWrongJoint || step.cause == Cause::kSettle ||
                           step.cause == Cause::kSymmetry || step.cause == Cause::kNone;
    const std::string said = fmt::format("capture {}: {}", evidence.image_fault_in, fault.sentence);
    if (fault.hurts) {
        reject(step, fault.cause, said);
    } else if (!explained) {
        step.cause = fault.cause;
        step.sentence = said + "; " + step.sentence;
    } else if (step.verdict == Verdict::kAccept && evidence.image_fault_in == step.to) {
        // The numbers hold, but a better picture of this view can be had: not to be merged unseen.
        step.verdict = Verdict::kCheck;
        step.cause = fault.cause;
        step.sentence = said + "; " + step.sentence;
    } else {
        step.sentence += "; note: " + said;
    }
}

}  // namespace

bool camera_moved(const StepEvidence& evidence) {
    return evidence.camera_shift && evidence.camera_shift->shift_px > kMostCameraShift_px;
}

bool much_unexplained(const StepEvidence& evidence) {
    return evidence.unexplained && evidence.unexplained->area_m2 > evidence.unexplained_limit_m2;
}

void diagnose_step(TurnStep& step, StepEvidence& evidence, const TurnLimits& limits) {
    judge_step(step, evidence, limits);
    evidence.foreign_object = much_unexplained(evidence) && one_thing(evidence);
    if (camera_moved(evidence)) {
        reject(step, Cause::kMovedCamera, moved_camera_sentence(*evidence.camera_shift));
    } else if (evidence.foreign_object) {
        reject(step, Cause::kMislabelled, foreign_sentence(evidence));
    } else if (slip_is_real(step, limits)) {
        reject(step, Cause::kSlip, slip_sentence(*step.grip_slip, limits));
    } else if (evidence.image_fault) {
        name_bad_images(step, evidence);
    }
}

}  // namespace gripscan
