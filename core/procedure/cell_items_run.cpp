// Items about disk and time.
#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/procedure/cell_items.h"

namespace gripscan {
namespace {

constexpr double kBytesPerMb = 1e6;
/// Results and journal beside the images: template, report, table.
constexpr double kResults_MB = 100.0;
/// Retakes and halved steps: three times the images of the plain turn.
constexpr double kSpare = 3.0;
/// Joint 6 of the arm at full speed, and what starting and stopping add to a motion.
constexpr double kFullSpeed_rad_s = 720.0 * kRadPerDeg;
constexpr double kStartStop_s = 0.5;

double captures_of(const TurnPlan& plan) {
    return std::ceil(plan.total_rad / plan.step_rad - 1e-9) + 1.0;
}

}  // namespace

CellCheckItem disk_item(const CellFacts& facts, const TurnPlan& plan) {
    if (!facts.disk) return skipped("disk", "MB", facts.disk.error());
    const double images = 2.0 * captures_of(plan) * kSpare;
    const double need_MB = std::ceil(
        images * static_cast<double>(facts.disk->image_bytes) / kBytesPerMb + kResults_MB);
    const double free_MB = std::floor(static_cast<double>(facts.disk->free_bytes) / kBytesPerMb);
    return with_sentence(
        at_least("disk", free_MB, need_MB, "MB"),
        fmt::format("{:.0f} MB free, the session may take {:.0f} MB", free_MB, need_MB),
        "free some, or put the session elsewhere");
}

CellCheckItem duration_item(const CellFacts& facts, const TurnPlan& plan,
                            const CellLimits& limits) {
    if (!facts.time) return skipped("duration", "min", facts.time.error());
    const double speed_rad_s = kFullSpeed_rad_s * plan.speed_percent / 100.0;
    const double motion_s = plan.step_rad / speed_rad_s + kStartStop_s;
    const double step_s =
        motion_s + facts.time->settle_s + facts.time->exposure_s + facts.time->compute_s;
    const double back_s = plan.total_rad / speed_rad_s;
    const double total_min = (captures_of(plan) * step_s + back_s) / 60.0;
    CellCheckItem item = at_most("duration", total_min, limits.duration_min, "min");
    if (item.outcome == CheckOutcome::kFailed) item.outcome = CheckOutcome::kWarned;
    return with_sentence(
        std::move(item),
        fmt::format("{:.0f} captures in about {:.1f} min: each {:.1f} s motion, {:.1f} s settling, "
                    "{:.1f} s exposure, {:.1f} s computing",
                    captures_of(plan), total_min, motion_s, facts.time->settle_s,
                    facts.time->exposure_s, facts.time->compute_s),
        "take larger steps or a higher speed");
}

}  // namespace gripscan
