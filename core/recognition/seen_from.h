// Which points of a part can be seen from where: directions spread over the sphere, and for each
// the points that face it and lie behind no other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/for_each.h"
#include "core/recognition/oriented_points.h"

namespace gripscan {

class SeenFrom {
  public:
    /// What of `points` is seen past `occluders`, which cover the part with a point for every
    /// square of side spacing_m.
    SeenFrom(const OrientedPoints& points, const OrientedPoints& occluders, double spacing_m,
             const ForEach& for_each);

    /// Points seen by a far camera in that direction from the part (unit, part's frame), rising.
    [[nodiscard]] std::span<const std::uint32_t> visible(const Eigen::Vector3f& towards) const;

    /// From how many of the directions a point is seen.
    [[nodiscard]] const std::vector<std::uint16_t>& times_seen() const { return times_seen_; }

  private:
    std::vector<std::vector<std::uint32_t>> visible_;  ///< of each direction
    std::vector<std::uint16_t> times_seen_;
};

/// The directions, evenly spread over the sphere.
[[nodiscard]] const std::vector<Eigen::Vector3f>& view_directions();

/// The part as seen from outside: points inside it are left out, and normals that have no side yet
/// (`oriented` false) are turned to where they are seen from.
[[nodiscard]] OrientedPoints outside_of(const OrientedPoints& part, bool oriented, double spacing_m,
                                        const ForEach& for_each);

}  // namespace gripscan
