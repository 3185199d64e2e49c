// What one view shows and the other ought to have seen but did not: the mark of something that
// does not belong to the part, or of a part that has changed.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "core/geometry/box.h"
#include "core/geometry/pose.h"
#include "core/registration/surface.h"
#include "core/registration/view_field.h"

namespace gripscan {

/// The largest compact piece of what is not explained.
struct Unexplained {
    std::size_t points = 0;
    double area_m2 = 0.0;
    double size_m = 0.0;                                 ///< largest extent
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< camera frame
    double standing = 0.0;       ///< share of its points that the other view has at the same place
    double other_area_m2 = 0.0;  ///< of everything else that is not explained
};

/// Where a point could have been seen in the other view.
struct SeenWhere {
    std::optional<Box> region;       ///< clouds are cut to it
    std::optional<ViewField> field;  ///< the other camera's
    /// Of the shown points, where it is known: a surface in the dark is easily lost by stereo.
    std::span<const float> brightness;
    /// What holds the part in the other view, which hides it too; null: nothing does.
    const Surface* holder = nullptr;
};

/// Points of `shown` that are well lit and cannot be the part's: moved by T they leave the region,
/// which holds the part at every angle (but for walls that cut it); or they face the other camera,
/// lie inside its field and the region, are not hidden by what it saw, and yet have no partner
/// there; or nothing is known of that place, and they are still where they were. Without region and
/// field, a direction without data says nothing and only places the other camera looked through
/// count. Nothing if all is explained, or without viewpoints.
[[nodiscard]] std::optional<Unexplained> unexplained_part(const Surface& shown,
                                                          const Surface& other,
                                                          const Pose& T_other_shown,
                                                          const SeenWhere& where);

}  // namespace gripscan
