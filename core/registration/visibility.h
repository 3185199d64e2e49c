// What a camera saw, as a depth map over its viewing directions: tells whether a surface at a
// given pose would contradict it.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/pose.h"
#include "core/registration/surface.h"

namespace gripscan {

enum class Sight {
    kSeen,     ///< on the surface the camera saw
    kHidden,   ///< behind it: nothing is known
    kInFront,  ///< where the camera looked through: a contradiction
    kNothing,  ///< in a direction without data
};

class DepthMap {
  public:
    /// The surface must have a viewpoint.
    explicit DepthMap(const Surface& surface);

    /// Where point p (m) lies; tolerance along the ray in m.
    [[nodiscard]] Sight look(const Eigen::Vector3f& p, float tolerance_m) const;

  private:
    [[nodiscard]] bool cell_of(const Eigen::Vector3f& local, int& column, int& row) const;

    Eigen::Matrix3f R_map_camera_;  ///< looks along z
    Eigen::Vector3f viewpoint_;
    float u0_ = 0.0F, v0_ = 0.0F, cells_per_unit_ = 1.0F;
    int width_ = 0, height_ = 0;
    std::vector<float> nearest_, farthest_;  ///< depth of each cell; +inf, −inf where unknown
};

/// How a pose fits what both cameras saw, as shares of the samples.
struct Agreement {
    double matched = 0.0;       ///< with a partner within the tolerance
    double contradicted = 0.0;  ///< where the other camera looked through
    double score = 0.0;         ///< what candidates are ranked by: matched − contradicted
};

/// Both directions, mean of the two. Without viewpoints only `matched` counts.
[[nodiscard]] Agreement agreement(const Surface& source, const Surface& target,
                                  const DepthMap* source_map, const DepthMap* target_map,
                                  std::span<const std::uint32_t> source_sample,
                                  std::span<const std::uint32_t> target_sample,
                                  const Pose& T_target_source, double tolerance_m);
/// Of so many points of each, spread over it; the tolerance is what a rough pose may miss.
[[nodiscard]] Agreement agreement_at(const Surface& source, const Surface& target,
                                     const Pose& T_target_source, std::size_t points);
/// A partner of a point may be this far away while the pose is rough.
[[nodiscard]] double rough_tolerance_m(const Surface& source, const Surface& target);

}  // namespace gripscan
