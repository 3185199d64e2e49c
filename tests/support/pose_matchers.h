// Poses compared the way people read them: degrees of rotation, millimetres at a place.
#pragma once

#include <gmock/gmock.h>

#include <ostream>

#include "core/base/units.h"
#include "core/geometry/pose.h"

namespace Eigen {
inline void PrintTo(const Isometry3d& T, std::ostream* out) {
    *out << "R, t = " << T.matrix().topRows<3>().format(IOFormat(6, DontAlignCols, ", ", "; "));
}
}  // namespace Eigen

namespace gripscan::test {

struct PoseError {
    double deg = 0.0;
    double mm = 0.0;  ///< how far `at` is from where it ought to be
};

[[nodiscard]] inline PoseError pose_error(const Pose& T, const Pose& truth,
                                          const Eigen::Vector3d& at_m) {
    return {deg_from_rad(rotation_angle_rad(T.linear() * truth.linear().transpose())),
            kMmPerM * (T * at_m - truth * at_m).norm()};
}

/// Rotation within `deg`, and the point at_m of the source carried to its place within `mm`.
MATCHER_P4(IsPose, truth, at_m, deg, mm,
           "is the pose to " + testing::PrintToString(deg) + " deg and " +
               testing::PrintToString(mm) + " mm") {
    const PoseError error = pose_error(arg, truth, at_m);
    *result_listener << "off by " << error.deg << " deg and " << error.mm << " mm";
    return error.deg <= deg && error.mm <= mm;
}

}  // namespace gripscan::test
