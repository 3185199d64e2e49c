#include "core/procedure/region_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base/units.h"
#include "core/stereo/search_area.h"

namespace gripscan {
namespace {

/// What semi-global matching knows of a disparity before it is refined.
constexpr double kMatched_px = 0.2;
/// A corner behind the camera is as far outside as can be said.
constexpr double kBehind_px = -1e6;

double margin_px(const Eigen::Vector2d& p, const ImageSize& image) {
    return std::min({p.x(), p.y(), image.width - 1.0 - p.x(), image.height - 1.0 - p.y()});
}

}  // namespace

VolumeFacts region_in_view(const Box& region, const RectifiedRig& rig) {
    VolumeFacts facts;
    facts.margin_px = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& corner : region.corners()) {
        const Eigen::Vector3d mm = kMmPerM * corner;
        const auto consider = [&](double margin, std::string_view image) {
            if (margin >= facts.margin_px) return;
            facts.margin_px = margin;
            facts.nearest = fmt::format("({:.0f}, {:.0f}, {:.0f}) mm in the {} image", mm.x(),
                                        mm.y(), mm.z(), image);
        };
        if (corner.z() <= 0.0) {
            consider(kBehind_px, "left");
            continue;
        }
        const Eigen::Vector2d left = rig.project(corner);
        const Eigen::Vector2d right(left.x() - rig.disparity_px(corner.z()), left.y());
        consider(margin_px(left, rig.image), "left");
        consider(margin_px(right, rig.image), "right");
    }
    facts.far_m = region.max_m.z();
    if (!(facts.far_m > 0.0)) return facts;
    facts.far_disparity_px = rig.disparity_px(facts.far_m);
    facts.can_be_matched = search_area(rig, region, {}).has_value();
    facts.far_sd_m = facts.far_m * facts.far_m / (rig.f_px * rig.baseline_m) * kMatched_px;
    return facts;
}

}  // namespace gripscan
