// A cloud made ready for registration: normals, noise, silhouette marks and a search tree, made
// once per view and then only read, so that views can be shared between threads.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/cloud/kd_tree.h"
#include "core/registration/texture_grid.h"

namespace gripscan {

struct Surface {
    std::vector<Eigen::Vector3f> points;   ///< m
    std::vector<Eigen::Vector3f> normals;  ///< unit
    std::vector<Eigen::Vector3f> rays;     ///< unit viewing directions; empty if unknown
    std::vector<float> sigma_m;            ///< along the ray (along the normal without rays)
    std::vector<std::uint8_t> rim;         ///< 1: next to a silhouette or a hole
    KdTree tree{std::span<const Eigen::Vector3f>{}};
    std::optional<Eigen::Vector3f> viewpoint;
    std::optional<TextureGrid> texture;  ///< where the cloud has an image grid and brightness
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    double radius_m = 0.0;   ///< rms distance of the points from the centre
    double spacing_m = 0.0;  ///< median distance to the nearest neighbour

    [[nodiscard]] std::size_t size() const { return points.size(); }
    /// Standard deviation of point i along the direction n, m.
    [[nodiscard]] float sigma_along(std::size_t i, const Eigen::Vector3f& n) const {
        return rays.empty() ? sigma_m[i] : sigma_m[i] * std::abs(n.dot(rays[i]));
    }
};

/// Computes what the cloud does not bring along (normals, noise). Error: fewer than 100 points.
[[nodiscard]] Result<Surface> make_surface(const Cloud& cloud);

/// At most `count` indices, spread evenly over the surface: one point of each cube of a grid whose
/// edge is made to fit. The same for the same surface.
[[nodiscard]] std::vector<std::uint32_t> spread_sample(const Surface& surface, std::size_t count);

}  // namespace gripscan
