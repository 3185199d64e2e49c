// The brightness of a view on its image grid, to be looked up where a point of space appears.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/cloud/cloud.h"

namespace gripscan {

/// The part of an organised cloud's image that holds points, with the pinhole camera that explains
/// the grid. Immutable.
class TextureGrid {
  public:
    /// Nothing if the cloud has no image grid, no intensities, no viewpoint, or if its grid is not
    /// that of a pinhole camera that looks along z.
    [[nodiscard]] static std::optional<TextureGrid> create(const Cloud& cloud);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// The cloud's point in a cell (row · width + column), −1 where there is none.
    [[nodiscard]] const std::vector<std::int32_t>& points() const { return point_; }
    /// Brightness of a cell, 0 … 255.
    [[nodiscard]] const std::vector<float>& brightness() const { return brightness_; }

    struct Sample {
        float value = 0.0F;
        float by_u = 0.0F;  ///< per px
        float by_v = 0.0F;
        float u = 0.0F;  ///< where p appears, px on the part of the grid
        float v = 0.0F;
        std::int32_t point = -1;  ///< nearest point of the cloud on that ray
    };
    /// Where the ray through p meets the image (Catmull–Rom); nothing next to its rim or outside.
    [[nodiscard]] std::optional<Sample> look(const Eigen::Vector3f& p) const;

    /// Gradient by p (1/m) of something with the gradient (by_u, by_v) in the image, at p.
    [[nodiscard]] Eigen::Vector3f gradient_at(const Eigen::Vector3f& p, float by_u,
                                              float by_v) const;

  private:
    struct Pinhole {
        float fx = 0.0F, fy = 0.0F, cx = 0.0F, cy = 0.0F;
    };
    bool fit_pinhole(const Cloud& cloud);
    void cut_out(const Cloud& cloud);

    Pinhole pinhole_;
    Eigen::Vector3f viewpoint_ = Eigen::Vector3f::Zero();
    int width_ = 0, height_ = 0;
    int first_column_ = 0, first_row_ = 0;  ///< its corner in the cloud's grid
    std::vector<std::int32_t> point_;
    std::vector<float> brightness_;
};

}  // namespace gripscan
