// The coarse search: from the identity and many perturbed starts to a few candidate poses.
#pragma once

#include <vector>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/registration/align.h"
#include "core/registration/surface.h"
#include "core/registration/visibility.h"

namespace gripscan {

/// A pose the search ended in.
struct Candidate {
    Pose T_target_source = Pose::Identity();
    Agreement agreement;
    int starts = 0;  ///< how many starts ended here
};

/// Rotations to start from: the identity, then rotations about any axis by up to `cone_rad`,
/// uniformly spread over the ball of rotation vectors, drawn from the seed.
[[nodiscard]] std::vector<Eigen::Matrix3d> start_rotations(int count, double cone_rad,
                                                           std::uint64_t seed);

/// Distinct candidates, best first. Nothing of the true motion is used.
[[nodiscard]] std::vector<Candidate> search(const Surface& source, const Surface& target,
                                            const DepthMap* source_map, const DepthMap* target_map,
                                            const AlignSettings& settings, double cone_rad,
                                            int starts, const ForEach& for_each);

}  // namespace gripscan
