// The walls of the registration area, and through which of them the part does not reach.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "core/geometry/box.h"

namespace gripscan {

class RegionWalls {
  public:
    /// A wall that points of the cloud come near (within the margin) may cut the part.
    RegionWalls(const Box& region, std::span<const Eigen::Vector3f> points, float margin_m);

    /// Outside by more than the margin, and only through walls that do not cut the part. The
    /// registration area holds the part at every angle, so no point of it can be there.
    [[nodiscard]] bool leaves(const Eigen::Vector3f& p) const;
    /// Inside, away from all walls by more than the margin.
    [[nodiscard]] bool deep_inside(const Eigen::Vector3f& p) const;

  private:
    /// Distances from the six walls, positive inside.
    [[nodiscard]] Eigen::Array<float, 6, 1> inside_m(const Eigen::Vector3f& p) const;

    Eigen::Array3f min_m_, max_m_;
    float margin_m_;
    std::array<bool, 6> cuts_{};
};

}  // namespace gripscan
