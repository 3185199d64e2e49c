// What the camera measured, by viewing direction: the point that was seen where a given point
// would be seen.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cloud/cloud.h"

namespace gripscan {

class ViewMap {
  public:
    /// The cloud's own image grid where its points lie on one; else a grid of its own. Uses
    /// nothing of the cloud later.
    ViewMap(const Cloud& cloud, const Eigen::Vector3f& viewpoint);

    struct Place {
        int column = -1;
        int row = -1;
        float depth_m = 0.0F;  ///< along the camera's axis; ≤ 0: behind the camera
    };
    [[nodiscard]] Place place_of(const Eigen::Vector3f& p) const {
        const Eigen::Vector3f l = R_map_scene_ * (p - viewpoint_);
        if (l.z() <= 0.0F) return {};
        const float scale = 1.0F / l.z();
        return {static_cast<int>(std::floor(fx_ * l.x() * scale + cx_)),
                static_cast<int>(std::floor(fy_ * l.y() * scale + cy_)), l.z()};
    }
    [[nodiscard]] bool inside(int column, int row) const {
        return column >= 0 && column < width_ && row >= 0 && row < height_;
    }
    /// Index of the point seen there, −1: none. The cell must be inside.
    [[nodiscard]] std::int32_t point_at(int column, int row) const {
        return index_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(column)];
    }
    [[nodiscard]] float depth_m(std::size_t point) const { return depth_m_[point]; }
    /// Nothing is measured there, but beside it in the row, on one side at least, something nearer
    /// than depth_m: the other camera of a stereo pair may have seen that instead, so the gap says
    /// nothing of what is at depth_m.
    [[nodiscard]] bool in_shadow(int column, int row, float depth_m) const {
        return beside_m_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                         static_cast<std::size_t>(column)] < depth_m;
    }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] const Eigen::Vector3f& viewpoint() const { return viewpoint_; }
    /// Cells a unit of x / z.
    [[nodiscard]] float cells_per_unit() const { return fx_; }
    /// Unit vectors of the map's columns and rows, scene frame.
    [[nodiscard]] Eigen::Vector3f across() const { return R_map_scene_.row(0); }
    [[nodiscard]] Eigen::Vector3f down() const { return R_map_scene_.row(1); }

  private:
    [[nodiscard]] bool fit_grid(const Cloud& cloud);
    void make_grid(const Cloud& cloud);
    void fill(const Cloud& cloud);
    void find_shadows();

    Eigen::Vector3f viewpoint_;
    Eigen::Matrix3f R_map_scene_;  ///< looks along z
    float fx_ = 1.0F, fy_ = 1.0F, cx_ = 0.0F, cy_ = 0.0F;
    int width_ = 0, height_ = 0;
    std::vector<std::int32_t> index_;
    std::vector<float> depth_m_;
    std::vector<float> beside_m_;  ///< of cells without a point: the nearer end of the gap
};

}  // namespace gripscan
