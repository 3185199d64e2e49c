// Evidence of every step of recorded sessions as CSV: what the limits of the diagnosis were read
// from, and how far healthy recordings stay below them. `step_evidence SESSION… [--lock SESSION…]`.
#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <string_view>

#include "core/base/units.h"
#include "core/concurrency/worker_pool.h"
#include "core/registration/diagnosis.h"
#include "core/session/session.h"

namespace gripscan {
namespace {

double or_nan(const std::optional<double>& value, double factor = 1.0) {
    return value ? factor * *value : std::numeric_limits<double>::quiet_NaN();
}

void print_step(const std::string& name, const TurnStep& step, const StepEvidence& e) {
    const double area = e.unexplained ? e.unexplained->area_m2 : 0.0;
    fmt::print(
        "{},{},{},{},{:.3f},{:.3f},{:.2f},{:.2f},{:.2f},{:.2f},{:.3f},{},{:.0f},{:.2f},{:.2f},"
        "{:.2f},{:.3f},\"{}\"\n",
        name, step.index, word(step.verdict), word(step.cause),
        or_nan(step.error_rad, deg_from_rad(1.0)), or_nan(step.sigma_rad, deg_from_rad(1.0)),
        or_nan(step.overlap), or_nan(step.tilt_rad, deg_from_rad(1.0)),
        or_nan(step.slip_m, kMmPerM), or_nan(step.axis_offset_m, kMmPerM),
        e.camera_shift ? e.camera_shift->shift_px : -1.0,
        e.camera_shift ? e.camera_shift->patches : 0, area * 1e6,
        e.unexplained_limit_m2 > 0.0 ? area / e.unexplained_limit_m2 : 0.0, e.misfit.value_or(-1.0),
        e.as_reported ? e.as_reported->matched : -1.0,
        e.as_reported ? e.as_reported->contradicted : -1.0, step.sentence);
}

/// `lock`: every step is locked to the axis, as if the operator had said so.
Status print_session(const std::string& folder, bool lock, const ForEach& for_each) {
    const auto session = open_session(folder);
    if (!session) return forward_error(session.error());
    TurnRecording recording = recording_of(*session);
    for (RecordedCapture& capture : recording.captures) {
        if (lock) capture.mode = TurnMode::kAxisLocked;
    }
    const auto computed = compute_turn(recording, compute_settings_of(*session), {}, for_each);
    if (!computed) return forward_error(computed.error());
    for (std::size_t i = 0; i < computed->report.steps.size(); ++i) {
        print_step(folder, computed->report.steps[i], computed->report.evidence[i]);
    }
    for (std::size_t k = 0; k < computed->health.size(); ++k) {
        const auto& h = computed->health[k];
        if (!h) continue;
        fmt::print("{},view {},fill {:.3f},glare {:.4f},contrast {:.2f},sharpness {:.3f}\n", folder,
                   k, h->fill, h->glare, h->contrast, h->sharpness);
    }
    return {};
}

}  // namespace
}  // namespace gripscan

int main(int argc, char** argv) {
    gripscan::WorkerPool pool(2);
    fmt::print(
        "session,step,verdict,cause,error_deg,sigma_deg,overlap,tilt_deg,slip_mm,offset_mm,"
        "background_px,patches,unexplained_mm2,unexplained_of_limit,misfit,"
        "shared,floating,sentence\n");
    bool lock = false;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--lock") {
            lock = true;
            continue;
        }
        const auto status = gripscan::print_session(argv[i], lock, pool.for_each());
        if (!status) fmt::print(stderr, "{}\n", status.error().message);
        std::fflush(stdout);
    }
    return argc > 1 ? 0 : 2;
}
