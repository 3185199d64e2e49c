#include "core/registration/diagnosed_step.h"

#include <algorithm>

#include "core/registration/axis_lock.h"
#include "core/registration/diagnosis.h"
#include "core/registration/grip_slip.h"
#include "core/registration/turn_rows.h"

namespace gripscan {
namespace {

bool locked(const StepEnd& to, const TurnSettings& settings) {
    return settings.method == TurnMethod::kTurn && to.facts.mode == TurnMode::kAxisLocked;
}

TurnStep locked_row(const StepEnd& from, const StepEnd& to, const Alignment& alignment,
                    std::optional<double> reported) {
    TurnStep step = step_row(from.facts, to.facts, alignment, TurnMethod::kTurn);
    step.mode = TurnMode::kAxisLocked;
    step.independent = false;
    if (step.T) step.icp_rad = reported;
    return step;
}

/// In which of the two views, and how much, is not explained by the motion T.
struct Look {
    std::optional<Unexplained> piece;
    int capture = 0;
    double total_m2 = 0.0;
};

const Surface* holder_of(const PreparedView& view) {
    return view.holder && view.holder->usable() ? &view.holder->surface : nullptr;
}

/// A view with bad images misses much that is there: it is no witness of what is not.
Look look(const StepEnd& from, const StepEnd& to, const Pose& T, const TurnSettings& settings) {
    std::optional<Unexplained> there;
    std::optional<Unexplained> back;
    if (!from.fault) {
        there = unexplained_part(
            to.view.surface, from.view.surface, T.inverse(),
            {settings.region, from.view.field, to.view.cloud.intensity, holder_of(from.view)});
    }
    if (!to.fault) {
        back = unexplained_part(
            from.view.surface, to.view.surface, T,
            {settings.region, to.view.field, from.view.cloud.intensity, holder_of(to.view)});
    }
    Look result{there, to.facts.index, 0.0};
    if (back && (!there || back->area_m2 > there->area_m2)) result = {back, from.facts.index, 0.0};
    for (const auto& piece : {there, back}) {
        if (piece) result.total_m2 += piece->area_m2 + piece->other_area_m2;
    }
    return result;
}

/// Under the motion that was found and, where that is not the robot's, under the robot's too:
/// what the better of the two leaves.
void look_for_unexplained(const TurnStep& step, const StepEnd& from, const StepEnd& to,
                          const std::optional<AxisEstimate>& axis, const TurnSettings& settings,
                          StepEvidence& evidence) {
    std::vector<Pose> motions;
    if (step.T) motions.push_back(*step.T);
    const bool agrees = step.error_rad && std::abs(*step.error_rad) <= settings.limits.angle_rad;
    if (axis && reported_rad(step) && !(step.T && agrees)) {
        motions.push_back(turn_about(axis->axis, *reported_rad(step)));
    }
    std::optional<Look> best;
    for (const Pose& T : motions) {
        Look seen = look(from, to, T, settings);
        if (!best || seen.total_m2 < best->total_m2) best = std::move(seen);
    }
    if (!best) return;
    evidence.unexplained = best->piece;
    evidence.unexplained_in = best->capture;
    const double radius_m = std::max(from.view.surface.radius_m, to.view.surface.radius_m);
    evidence.unexplained_limit_m2 = kMostUnexplained * radius_m * radius_m;
}

/// Needs no alignment: it tells why there is none.
void look_as_reported(const TurnStep& step, const StepEnd& from, const StepEnd& to,
                      const std::optional<AxisEstimate>& axis, const TurnSettings& settings,
                      StepEvidence& evidence) {
    const auto reported = reported_rad(step);
    if (!axis || !reported) return;
    evidence.as_reported =
        agreement_at(from.view.surface, to.view.surface, turn_about(axis->axis, *reported),
                     settings.align.coarse_points);
}

void take_image_fault(const StepEnd& from, const StepEnd& to, StepEvidence& evidence) {
    for (const StepEnd* end : {&to, &from}) {
        if (!end->fault) continue;
        if (evidence.image_fault && evidence.image_fault->excess >= end->fault->excess) continue;
        evidence.image_fault = end->fault;
        evidence.image_fault_in = end->facts.index;
    }
}

void overrule(TurnStep& step, const std::string& note) {
    if (note.empty() || !step.T || step.verdict == Verdict::kAccept) return;
    step.verdict = Verdict::kAcceptNoted;
    step.sentence += "; accepted with note: " + note;
}

}  // namespace

TurnStep measured_step(const StepEnd& from, const StepEnd& to, const StepFinding& finding,
                       const TurnSettings& settings) {
    if (locked(to, settings)) return locked_row(from, to, {}, std::nullopt);
    return step_row(from.facts, to.facts, finding.alignment, settings.method);
}

DiagnosedStep diagnosed_step(const StepEnd& from, const StepEnd& to, const StepFinding& finding,
                             const std::optional<AxisEstimate>& axis,
                             const TurnSettings& settings) {
    DiagnosedStep judged;
    judged.step = measured_step(from, to, finding, settings);
    auto lost = without_alignment(from.facts, from.view);
    if (!lost) lost = without_alignment(to.facts, to.view);
    const bool usable = !lost;
    const bool is_locked = locked(to, settings);
    Alignment alignment = lost ? std::move(*lost) : finding.alignment;
    if (is_locked && usable) {
        const auto reported = reported_rad(judged.step);
        alignment = locked_alignment(from.view, to.view, axis, reported, settings.align);
        judged.step = locked_row(from, to, alignment, reported);
    }
    compare_with_axis(judged.step, axis);
    if (usable && !is_locked && settings.method == TurnMethod::kTurn) {
        judged.step.grip_slip = measure_grip_slip(from.view, to.view, alignment, settings.align);
    }
    judged.evidence = evidence_of(from.facts, to.facts, alignment, settings.method);
    judged.evidence.camera_shift = finding.camera_shift;
    if (is_locked && alignment.found) judged.evidence.misfit = alignment.misfit;
    take_image_fault(from, to, judged.evidence);
    if (usable && settings.method == TurnMethod::kTurn) {
        look_as_reported(judged.step, from, to, axis, settings, judged.evidence);
        look_for_unexplained(judged.step, from, to, axis, settings, judged.evidence);
    }
    diagnose_step(judged.step, judged.evidence, settings.limits);
    overrule(judged.step, to.facts.note);
    return judged;
}

std::vector<std::optional<ImageFault>> image_faults(std::span<const PreparedView* const> views) {
    std::vector<std::optional<ImageFault>> faults(views.size());
    for (std::size_t k = 0; k < views.size(); ++k) {
        if (!views[k]->image) continue;
        std::vector<ImageHealth> others;
        for (std::size_t j = 0; j < views.size(); ++j) {
            if (j != k && views[j]->image) others.push_back(*views[j]->image);
        }
        faults[k] = image_fault(*views[k]->image, others);
    }
    return faults;
}

}  // namespace gripscan
