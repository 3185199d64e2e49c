// Exact distance from points to a surface of triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace gripscan::test {

struct Surface {
    std::vector<Eigen::Vector3d> vertices;  ///< m
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The point of the triangle a b c nearest to p (Ericson 2005, 5.1.5).
[[nodiscard]] Eigen::Vector3d nearest_in_triangle(const Eigen::Vector3d& p,
                                                  const Eigen::Vector3d& a,
                                                  const Eigen::Vector3d& b,
                                                  const Eigen::Vector3d& c);

class SurfaceDistance {
  public:
    explicit SurfaceDistance(Surface surface);
    ~SurfaceDistance();
    SurfaceDistance(const SurfaceDistance&) = delete;
    SurfaceDistance& operator=(const SurfaceDistance&) = delete;

    [[nodiscard]] double distance_m(const Eigen::Vector3d& p_m) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace gripscan::test
