#include "core/registration/image_health.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace gripscan {
namespace {

/// Others that are needed before a comparison means anything.
constexpr std::size_t kFewestOthers = 2;
/// A frame is over-exposed where this much more of it is at the end of the scale than elsewhere,
/// or this much of it whatever the others show.
constexpr double kMoreGlare = 0.05;
constexpr double kMostGlare = 0.25;
/// Shares of the others' median below which a frame is out of focus or flat.
constexpr double kLeastSharpness = 0.6;
constexpr double kLeastContrast = 0.5;
/// A surface with less contrast than this has no texture for stereo, whatever the others show:
/// it is below the noise of an ordinary sensor.
constexpr double kFlat_levels = 1.5;
/// A capture with less than this share of the others' fill is no witness any more.
constexpr double kLeastFill = 0.5;

using Field = double ImageHealth::*;

double median(std::span<const ImageHealth> others, Field field) {
    std::vector<double> values;
    for (const ImageHealth& one : others) values.push_back(one.*field);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

ImageFault glare_fault(const ImageHealth& c, double usual) {
    const double limit = std::min(kMostGlare, usual + kMoreGlare);
    return {Cause::kExposure, c.glare / limit,
            fmt::format("{:.1f} % of the registration area is over-exposed, elsewhere {:.1f} %, "
                        "limit {:.1f} %: glare or too long an exposure",
                        100.0 * c.glare, 100.0 * usual, 100.0 * limit)};
}

ImageFault focus_fault(const ImageHealth& c, double usual) {
    const double limit = kLeastSharpness * usual;
    return {Cause::kTexture, limit / std::max(c.sharpness, 1e-6),
            fmt::format("sharpness {:.2f}, elsewhere {:.2f}, limit {:.2f}: out of focus or moved "
                        "during the exposure",
                        c.sharpness, usual, limit)};
}

ImageFault contrast_fault(const ImageHealth& c, double usual) {
    const double limit = std::max(kFlat_levels, kLeastContrast * usual);
    return {Cause::kTexture, limit / std::max(c.contrast, 1e-6),
            fmt::format("contrast of the surface {:.1f} levels, elsewhere {:.1f}, limit {:.1f}: "
                        "too little texture for stereo",
                        c.contrast, usual, limit)};
}

}  // namespace

std::optional<ImageFault> image_fault(const ImageHealth& capture,
                                      std::span<const ImageHealth> others) {
    const bool compared = others.size() >= kFewestOthers;
    const auto usual = [&](Field field, double alone) {
        return compared ? median(others, field) : alone;
    };
    std::vector<ImageFault> faults{glare_fault(capture, usual(&ImageHealth::glare, kMostGlare)),
                                   contrast_fault(capture, usual(&ImageHealth::contrast, 0.0))};
    if (compared) faults.push_back(focus_fault(capture, median(others, &ImageHealth::sharpness)));
    ImageFault worst = *std::max_element(
        faults.begin(), faults.end(),
        [](const ImageFault& a, const ImageFault& b) { return a.excess < b.excess; });
    if (worst.excess <= 1.0) return std::nullopt;
    const double fill = usual(&ImageHealth::fill, 0.0);
    if (capture.fill < kLeastFill * fill) {
        worst.hurts = true;
        worst.sentence += fmt::format("; stereo fills {:.0f} %, elsewhere {:.0f} %",
                                      100.0 * capture.fill, 100.0 * fill);
    }
    return worst;
}

}  // namespace gripscan
