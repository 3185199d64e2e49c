#include "core/procedure/view_evidence.h"

#include "core/stereo/search_area.h"

namespace gripscan {

ImageHealth image_health_of(const StereoHealth& health) {
    return {health.fill, health.glare, health.contrast, health.sharpness};
}

ViewField field_of(const RectifiedRig& rig) {
    ViewField field;
    field.min = {-rig.cx_left_px / rig.f_px, -rig.cy_px / rig.f_px};
    field.max = {(rig.image.width - 1 - rig.cx_left_px) / rig.f_px,
                 (rig.image.height - 1 - rig.cy_px) / rig.f_px};
    field.min.x() = std::max(field.min.x(), -rig.cx_right_px / rig.f_px);
    field.baseline_m = rig.baseline_m;
    return field;
}

std::optional<Background> background_beside(const StereoFrame& rectified, const RectifiedRig& rig,
                                            const std::optional<Box>& region) {
    if (!region) return std::nullopt;
    const auto area = search_area(rig, region, {});
    if (!area) return std::nullopt;
    return background_of(rectified.left, area->roi);
}

std::optional<CameraShift> camera_shift_of(const Background& before, const Background& now) {
    const auto shift = background_shift(before, now);
    if (!shift) return std::nullopt;
    return CameraShift{shift->shift_px, shift->noise_px, shift->agreeing, shift->patches};
}

}  // namespace gripscan
