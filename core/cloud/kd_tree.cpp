#include "core/cloud/kd_tree.h"

#include <algorithm>
#include <limits>
#include <nanoflann.hpp>

namespace gripscan {
namespace {

/// How nanoflann sees the points.
struct PointSet {
    std::vector<Eigen::Vector3f> points;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
    [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return points[i][static_cast<Eigen::Index>(axis)];
    }
    template <typename Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PointSet>,
                                                 PointSet, 3, std::uint32_t>;
constexpr std::size_t kLeafSize = 16;

/// The nearest one below a limit: nanoflann's own result sets know either a count or a radius.
class NearestBelow {
  public:
    explicit NearestBelow(float squared_limit) : best_{0, squared_limit} {}

    [[nodiscard]] std::size_t size() const { return found_ ? 1 : 0; }
    [[nodiscard]] bool full() const { return true; }
    [[nodiscard]] float worstDist() const { return best_.squared_distance_m2; }
    bool addPoint(float squared_distance, std::uint32_t index) {
        // nanoflann reads the limit once a leaf, so points beyond the best one arrive here too.
        if (squared_distance < best_.squared_distance_m2) {
            best_ = {index, squared_distance};
            found_ = true;
        }
        return true;
    }
    [[nodiscard]] std::optional<Neighbour> result() const {
        if (!found_) return std::nullopt;
        return best_;
    }

  private:
    Neighbour best_;
    bool found_ = false;
};

/// Everything below a limit, straight into the caller's vector.
class AllBelow {
  public:
    AllBelow(float squared_limit, std::vector<Neighbour>& found)
        : squared_limit_(squared_limit), found_(found) {}

    [[nodiscard]] std::size_t size() const { return found_.size(); }
    [[nodiscard]] bool full() const { return true; }
    [[nodiscard]] float worstDist() const { return squared_limit_; }
    bool addPoint(float squared_distance, std::uint32_t index) {
        if (squared_distance < squared_limit_) found_.push_back({index, squared_distance});
        return true;
    }

  private:
    float squared_limit_;
    std::vector<Neighbour>& found_;
};

/// The k nearest, kept in order by insertion: k is small.
class KNearest {
  public:
    KNearest(std::size_t k, std::vector<Neighbour>& found) : k_(k), found_(found) {}

    [[nodiscard]] std::size_t size() const { return found_.size(); }
    [[nodiscard]] bool full() const { return found_.size() == k_; }
    [[nodiscard]] float worstDist() const {
        return full() ? found_.back().squared_distance_m2 : std::numeric_limits<float>::max();
    }
    bool addPoint(float squared_distance, std::uint32_t index) {
        if (squared_distance >= worstDist()) return true;
        if (full()) found_.pop_back();
        const auto nearer = [](float d, const Neighbour& n) { return d < n.squared_distance_m2; };
        found_.insert(std::upper_bound(found_.begin(), found_.end(), squared_distance, nearer),
                      {index, squared_distance});
        return true;
    }

  private:
    std::size_t k_;
    std::vector<Neighbour>& found_;
};

}  // namespace

struct KdTree::Index {
    PointSet set;
    Tree tree;

    explicit Index(std::span<const Eigen::Vector3f> points)
        : set{{points.begin(), points.end()}},
          tree(3, set, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize)) {}

    template <typename ResultSet>
    void search(ResultSet& result, const Eigen::Vector3f& query) const {
        if (set.points.empty()) return;
        tree.findNeighbors(result, query.data(), nanoflann::SearchParams());
    }
};

KdTree::KdTree(std::span<const Eigen::Vector3f> points) : index_(std::make_unique<Index>(points)) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

std::size_t KdTree::size() const {
    return index_->set.points.size();
}

std::optional<Neighbour> KdTree::nearest(const Eigen::Vector3f& query) const {
    NearestBelow result(std::numeric_limits<float>::infinity());
    index_->search(result, query);
    return result.result();
}

std::optional<Neighbour> KdTree::nearest_within(const Eigen::Vector3f& query,
                                                float radius_m) const {
    NearestBelow result(radius_m * radius_m);
    index_->search(result, query);
    return result.result();
}

void KdTree::k_nearest(const Eigen::Vector3f& query, std::size_t k,
                       std::vector<Neighbour>& found) const {
    found.clear();
    if (k == 0) return;
    KNearest result(k, found);
    index_->search(result, query);
}

void KdTree::all_within(const Eigen::Vector3f& query, float radius_m,
                        std::vector<Neighbour>& found) const {
    found.clear();
    AllBelow result(radius_m * radius_m, found);
    index_->search(result, query);
}

}  // namespace gripscan
