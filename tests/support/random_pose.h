// Poses for tests that check laws on many of them.
#pragma once

#include "core/base/seeded_random.h"
#include "core/geometry/pose.h"

namespace gripscan::test {

inline Eigen::Vector3d random_direction(SeededRandom& random) {
    return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/// A turn of up to max_angle_rad about any axis, a shift of up to a metre in each direction.
inline Pose random_pose(SeededRandom& random, double max_angle_rad) {
    Pose T = Pose::Identity();
    const double angle_rad = random.uniform(0.0, max_angle_rad);
    T.linear() = Eigen::AngleAxisd(angle_rad, random_direction(random)).toRotationMatrix();
    T.translation() =
        Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    return T;
}

}  // namespace gripscan::test
