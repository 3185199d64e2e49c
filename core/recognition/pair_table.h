// Point pair features (Drost, Ulrich, Navab, Ilic 2010): every pair of a part's oriented points,
// found again by its distance and its three angles, which no motion changes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/pose.h"
#include "core/recognition/oriented_points.h"

namespace gripscan {

/// Lays the point in the origin and its normal along x; what then is left of a pose that maps one
/// oriented point onto another is an angle about x.
[[nodiscard]] Eigen::Isometry3f onto_x(const Eigen::Vector3f& point, const Eigen::Vector3f& normal);

class PairTable {
  public:
    /// Distances are told apart by step_m.
    PairTable(const OrientedPoints& part, double step_m);

    struct Pair {
        std::uint16_t reference = 0;  ///< index of the first point
        std::uint16_t angle = 0;      ///< of the second about the first's normal, kTurn a turn
    };
    static constexpr int kTurn = 1 << 16;

    /// Pairs with about this feature; empty where the part has none.
    [[nodiscard]] std::span<const Pair> find(const Eigen::Vector3f& p1, const Eigen::Vector3f& n1,
                                             const Eigen::Vector3f& p2,
                                             const Eigen::Vector3f& n2) const;
    [[nodiscard]] float longest_m() const { return longest_m_; }

  private:
    static constexpr int kAngles = 15;  ///< bins for 0 … 180°
    struct Feature {
        float distance;               ///< in bins
        std::array<float, 3> angles;  ///< in bins
    };
    [[nodiscard]] Feature feature(const Eigen::Vector3f& p1, const Eigen::Vector3f& n1,
                                  const Eigen::Vector3f& p2, const Eigen::Vector3f& n2) const;
    template <typename Use>
    void for_each_pair(const OrientedPoints& part, Use use) const;

    float bins_per_m_;
    float longest_m_ = 0.0F;
    int distances_ = 0;
    std::vector<std::uint32_t> begin_;  ///< of every bin's pairs
    std::vector<Pair> pairs_;
};

}  // namespace gripscan
