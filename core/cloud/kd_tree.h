// Nearest neighbours among points that do not move. A thin cover over nanoflann, so that its
// templates are compiled once. Queries are const, need no lock and may run side by side; the same
// points give the same answers in every run.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gripscan {

struct Neighbour {
    std::uint32_t index = 0;
    float squared_distance_m2 = 0.0F;
};

class KdTree {
  public:
    /// Keeps a copy of the points, which must be finite.
    explicit KdTree(std::span<const Eigen::Vector3f> points);
    ~KdTree();
    KdTree(KdTree&&) noexcept;
    KdTree& operator=(KdTree&&) noexcept;

    [[nodiscard]] std::size_t size() const;

    /// Nothing if there are no points.
    [[nodiscard]] std::optional<Neighbour> nearest(const Eigen::Vector3f& query) const;

    /// Nothing if no point lies closer than radius_m. A small radius makes the search faster.
    [[nodiscard]] std::optional<Neighbour> nearest_within(const Eigen::Vector3f& query,
                                                          float radius_m) const;

    /// The k nearest ones, nearest first; fewer if there are fewer points. `found` is reused.
    void k_nearest(const Eigen::Vector3f& query, std::size_t k,
                   std::vector<Neighbour>& found) const;

    /// All that lie closer than radius_m, in no particular but always the same order.
    void all_within(const Eigen::Vector3f& query, float radius_m,
                    std::vector<Neighbour>& found) const;

  private:
    struct Index;
    std::unique_ptr<Index> index_;
};

}  // namespace gripscan
