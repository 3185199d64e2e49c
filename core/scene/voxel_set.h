// Which cubes of space are occupied: a sorted list of their places.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace gripscan {

class VoxelSet {
  public:
    VoxelSet() = default;
    /// `keys` rise and are unique; see key_of().
    VoxelSet(double voxel_m, std::vector<std::uint64_t> keys)
        : voxel_m_(voxel_m), keys_(std::move(keys)) {}

    /// Cubes that hold at least `fewest` of the points.
    [[nodiscard]] static VoxelSet of(double voxel_m, std::span<const Eigen::Vector3f> points,
                                     std::size_t fewest);

    /// The cube of a point; nothing is known beyond ±1 million cubes, where all places are one.
    [[nodiscard]] static std::uint64_t key_of(const Eigen::Vector3d& p_m, double voxel_m);

    /// The point's cube or one of the 26 around it is occupied.
    [[nodiscard]] bool near(const Eigen::Vector3d& p_m) const;
    /// The point's own cube is occupied.
    [[nodiscard]] bool contains(const Eigen::Vector3d& p_m) const;
    /// Middles of the occupied cubes, m.
    [[nodiscard]] std::vector<Eigen::Vector3f> centres_m() const;
    /// What is in either of both (of the same voxel size, or empty).
    void merge(const VoxelSet& other);

    [[nodiscard]] bool empty() const { return keys_.empty(); }
    [[nodiscard]] std::size_t size() const { return keys_.size(); }
    [[nodiscard]] double voxel_m() const { return voxel_m_; }
    [[nodiscard]] const std::vector<std::uint64_t>& keys() const { return keys_; }

  private:
    double voxel_m_ = 0.008;
    std::vector<std::uint64_t> keys_;
};

}  // namespace gripscan
