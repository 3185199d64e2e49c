#include "core/recognition/view_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/cloud/kd_tree.h"

namespace gripscan {
namespace {

/// Points of an image lie at least this near (in cells) to where a pinhole puts them.
constexpr double kPinholeMisfit = 0.3;
constexpr int kLargestSide = 4096;
/// Widest shadow of a near thing, in shares of the image's width: of one at 0.5 m on one at 0.75 m,
/// seen by cameras 0.12 m apart.
constexpr double kWidestShadow = 0.0625;

/// Slope and offset of b over a, and the largest of nearly all misfits.
struct Line {
    double slope = 0.0;
    double offset = 0.0;
    double misfit = 1e9;
};
Line fit_line(const std::vector<std::array<double, 2>>& pairs) {
    double n = 0, a = 0, b = 0, aa = 0, ab = 0;
    for (const auto& [x, y] : pairs) {
        n += 1;
        a += x;
        b += y;
        aa += x * x;
        ab += x * y;
    }
    const double det = n * aa - a * a;
    if (!(det > 0.0)) return {};
    Line line;
    line.slope = (n * ab - a * b) / det;
    line.offset = (b - line.slope * a) / n;
    double squares = 0.0;
    for (const auto& [x, y] : pairs) {
        const double r = y - line.slope * x - line.offset;
        squares += r * r;
    }
    line.misfit = std::sqrt(squares / n);
    return line;
}

Eigen::Matrix3f looking_along(int sign) {
    Eigen::Matrix3f R = Eigen::Matrix3f::Identity();
    if (sign < 0) R.diagonal() << 1.0F, -1.0F, -1.0F;
    return R;
}

}  // namespace

ViewMap::ViewMap(const Cloud& cloud, const Eigen::Vector3f& viewpoint) : viewpoint_(viewpoint) {
    if (!cloud.organised() || !fit_grid(cloud)) make_grid(cloud);
    fill(cloud);
}

/// An organised cloud of a camera that looks along z (or −z): the pinhole that its points obey.
bool ViewMap::fit_grid(const Cloud& cloud) {
    std::size_t in_front = 0;
    for (const auto& p : cloud.points) in_front += p.z() > viewpoint_.z() ? 1 : 0;
    if (in_front != 0 && in_front != cloud.size()) return false;
    R_map_scene_ = looking_along(in_front == 0 ? -1 : 1);
    std::vector<std::array<double, 2>> columns;
    std::vector<std::array<double, 2>> rows;
    const std::size_t stride = std::max<std::size_t>(1, cloud.size() / 5000);
    for (std::size_t i = 0; i < cloud.size(); i += stride) {
        const Eigen::Vector3d l = (R_map_scene_ * (cloud.points[i] - viewpoint_)).cast<double>();
        columns.push_back({l.x() / l.z(), cloud.cell[i] % cloud.grid_width + 0.5});
        rows.push_back({l.y() / l.z(), cloud.cell[i] / cloud.grid_width + 0.5});
    }
    const Line u = fit_line(columns);
    const Line v = fit_line(rows);
    if (u.misfit > kPinholeMisfit || v.misfit > kPinholeMisfit) return false;
    fx_ = static_cast<float>(u.slope);
    cx_ = static_cast<float>(u.offset);
    fy_ = static_cast<float>(v.slope);
    cy_ = static_cast<float>(v.offset);
    width_ = cloud.grid_width;
    height_ = cloud.grid_height;
    return true;
}

/// Cells of nearly two point distances: fine enough for the shape, coarse enough to have no holes.
void ViewMap::make_grid(const Cloud& cloud) {
    const Eigen::Vector3f forward = centroid(cloud).cast<float>() - viewpoint_;
    R_map_scene_ =
        Eigen::Quaternionf::FromTwoVectors(forward.normalized(), Eigen::Vector3f::UnitZ())
            .toRotationMatrix();
    Eigen::Array2f low = Eigen::Array2f::Constant(1e9F);
    Eigen::Array2f high = -low;
    std::vector<Eigen::Vector3f> directions;
    for (const auto& p : cloud.points) {
        const Eigen::Vector3f l = R_map_scene_ * (p - viewpoint_);
        if (l.z() < 0.05F * l.norm()) continue;
        const Eigen::Array2f d = l.head<2>().array() / l.z();
        low = low.min(d);
        high = high.max(d);
        directions.emplace_back(d.x(), d.y(), 0.0F);
    }
    float spacing = 1.0F;
    if (directions.size() > 5) {
        const KdTree tree(directions);
        std::vector<float> distances;
        std::vector<Neighbour> found;
        const std::size_t stride = std::max<std::size_t>(1, directions.size() / 1000);
        for (std::size_t i = 0; i < directions.size(); i += stride) {
            tree.k_nearest(directions[i], 5, found);
            distances.push_back(std::sqrt(found[4].squared_distance_m2));
        }
        const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
        std::nth_element(distances.begin(), middle, distances.end());
        spacing = std::max(1e-6F, *middle);
    }
    const Eigen::Array2f extent = (high - low).max(0.0F);
    const float finest = extent.maxCoeff() / static_cast<float>(kLargestSide - 2);
    fx_ = fy_ = 1.0F / std::max(1.7F * spacing, finest);
    cx_ = 0.5F - low.x() * fx_;
    cy_ = 0.5F - low.y() * fy_;
    width_ = static_cast<int>(extent.x() * fx_) + 2;
    height_ = static_cast<int>(extent.y() * fy_) + 2;
}

void ViewMap::fill(const Cloud& cloud) {
    index_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), -1);
    depth_m_.resize(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Place at = place_of(cloud.points[i]);
        depth_m_[i] = at.depth_m;
        if (at.depth_m <= 0.0F || !inside(at.column, at.row)) continue;
        std::int32_t& index =
            index_[static_cast<std::size_t>(at.row) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(at.column)];
        if (index < 0 || at.depth_m < depth_m_[static_cast<std::size_t>(index)]) {
            index = static_cast<std::int32_t>(i);
        }
    }
    find_shadows();
}

void ViewMap::find_shadows() {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    const int widest = std::max(1, static_cast<int>(kWidestShadow * width_));
    beside_m_.assign(index_.size(), kFar);
    for (int row = 0; row < height_; ++row) {
        const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
        const auto sweep = [&](int from, int to, int way) {
            float last_m = kFar;
            int ends = 0;
            for (int column = from; column != to; column += way) {
                const std::size_t i = first + static_cast<std::size_t>(column);
                if (index_[i] >= 0) {
                    last_m = depth_m_[static_cast<std::size_t>(index_[i])];
                    ends = widest;
                } else if (ends > 0) {
                    --ends;
                    beside_m_[i] = std::min(beside_m_[i], last_m);
                }
            }
        };
        sweep(0, width_, 1);
        sweep(width_ - 1, -1, -1);
    }
}

}  // namespace gripscan
