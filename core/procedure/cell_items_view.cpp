// Items about what the cameras see.
#include <fmt/format.h>

#include "core/base/units.h"
#include "core/procedure/cell_items.h"

namespace gripscan {

CellCheckItem volume_item(const CellFacts& facts, const CellLimits& limits) {
    if (!facts.volume) return skipped("volume", "px", facts.volume.error());
    CellCheckItem item = at_least("volume", facts.volume->margin_px, 0, "px");
    if (item.outcome == CheckOutcome::kPassed &&
        facts.volume->margin_px < limits.volume_margin_px) {
        item.outcome = CheckOutcome::kWarned;
    }
    return with_sentence(std::move(item),
                         fmt::format("of the region's corners {} is nearest a border: {:.0f} px",
                                     facts.volume->nearest, facts.volume->margin_px),
                         "move the camera back or towards it, or make the region smaller");
}

CellCheckItem depth_item(const CellFacts& facts, const CellLimits& limits) {
    if (!facts.volume) return skipped("depth", "mm", facts.volume.error());
    const VolumeFacts& volume = *facts.volume;
    const double sd_mm = kMmPerM * volume.far_sd_m;
    CellCheckItem item = at_most("depth", sd_mm, limits.depth_sd_mm, "mm");
    if (!volume.can_be_matched) item.outcome = CheckOutcome::kFailed;
    return with_sentence(
        std::move(item),
        volume.can_be_matched
            ? fmt::format("the far side at {:.2f} m has a disparity of {:.0f} px: depth is good to "
                          "{:.2f} mm there",
                          volume.far_m, volume.far_disparity_px, sd_mm)
            : fmt::format("the region reaches from {:.2f} m out of what can be matched",
                          volume.far_m),
        "move the camera nearer or further away, or take a longer baseline");
}

std::vector<CellCheckItem> image_items(const CellFacts& facts, const CellLimits& limits) {
    if (!facts.image) {
        const std::string& why = facts.image.error();
        // Without a look at the region nothing about the turn is known: that is no pass. A region
        // out of sight has failed by its volume.
        const bool in_sight =
            !facts.volume || (facts.volume->margin_px >= 0.0 && facts.volume->can_be_matched);
        CellCheckItem surface = skipped("surface", "points", why);
        if (in_sight) {
            surface.outcome = CheckOutcome::kFailed;
            surface.sentence += "; set the region and let both cameras see it, then check again";
        }
        return {skipped("exposure", "%", why), skipped("brightness", "levels", why),
                skipped("texture", "levels", why), skipped("fill", "%", why), surface};
    }
    const ImageFacts& image = *facts.image;
    return {
        with_sentence(at_most("exposure", 100.0 * image.saturated, limits.saturated_percent, "%"),
                      fmt::format("{:.2f} % of the region's image is black or white",
                                  100.0 * image.saturated),
                      "expose shorter, or shade reflections and light the dark"),
        with_sentence(at_least("brightness", image.brightness, limits.least_brightness, "levels"),
                      fmt::format("mean brightness {:.0f} of 255", image.brightness),
                      "expose longer or light the gripper"),
        with_sentence(at_least("texture", image.contrast, limits.least_contrast, "levels"),
                      fmt::format("median contrast {:.1f} levels", image.contrast),
                      "check the focus, or give the surface texture (dull spray, speckles, a "
                      "projected pattern)"),
        with_sentence(at_least("fill", 100.0 * image.fill, limits.least_fill_percent, "%"),
                      fmt::format("{:.0f} % of the textured pixels have a depth inside the region",
                                  100.0 * image.fill),
                      "check calibration and focus, and whether the region holds the gripper"),
        with_sentence(
            at_least("surface", static_cast<double>(image.points), limits.least_points, "points"),
            fmt::format("{} points inside the region", image.points),
            "bring the gripper into the region")};
}

}  // namespace gripscan
