#include "core/procedure/region_stillness.h"

#include <memory>

#include "core/stereo/rectifier.h"
#include "core/stereo/search_area.h"
#include "core/stereo/stillness.h"

namespace gripscan {

Result<StillnessTest> region_stillness(const StereoRig& rig, const std::optional<Box>& region) {
    auto made = Rectifier::create(rig);
    if (!made) return forward_error(made.error());
    auto rectifier = std::make_shared<const Rectifier>(std::move(*made));
    const auto area = search_area(rectifier->rig(), region, {});
    if (!area) return forward_error(area.error());
    return StillnessTest([rectifier, roi = area->roi](
                             const StereoFrame& first,
                             const StereoFrame& second) -> std::optional<std::string> {
        const auto a = rectifier->rectify(first);
        const auto b = rectifier->rectify(second);
        if (!a || !b) return std::nullopt;
        const auto seen = stillness(a->left, b->left, roi);
        if (!seen || seen->still()) return std::nullopt;
        return fmt::format("two exposures differ by {:.3f} px, noise alone gives up to {:.3f} px",
                           seen->motion_px, seen->least_seen_px);
    });
}

}  // namespace gripscan
