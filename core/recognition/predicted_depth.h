// The depth image that the camera would measure of a template at a pose, were it alone.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/pose.h"
#include "core/recognition/oriented_points.h"
#include "core/recognition/scene_view.h"
#include "core/recognition/template_model.h"

namespace gripscan {

class PredictedDepth {
  public:
    /// All dense points that face the camera, each as a disc as wide as their spacing; the nearest
    /// one of a cell counts.
    PredictedDepth(const TemplateModel& model, const SceneView& scene,
                   const Pose& T_scene_template);

    /// Cells of the map that hold the part: columns [first_column, first_column + width).
    [[nodiscard]] int first_column() const { return first_column_; }
    [[nodiscard]] int first_row() const { return first_row_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// Index into surface() of what is seen at that cell of the map; −1: nothing of the part.
    [[nodiscard]] std::int32_t at(int column, int row) const {
        const int c = column - first_column_;
        const int r = row - first_row_;
        if (c < 0 || r < 0 || c >= width_ || r >= height_) return -1;
        return index_[static_cast<std::size_t>(r) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(c)];
    }
    /// Points that face the camera, scene frame.
    [[nodiscard]] const OrientedPoints& surface() const { return surface_; }
    /// The template ends there, though the part may go on.
    [[nodiscard]] bool border(std::int32_t i) const {
        return border_[static_cast<std::size_t>(i)] != 0;
    }
    /// Depth of such a point along the camera's axis, m.
    [[nodiscard]] float depth_m(std::int32_t i) const {
        return depth_m_[static_cast<std::size_t>(i)];
    }

  private:
    void frame(const std::vector<ViewMap::Place>& places, const SceneView& scene, int margin);
    void draw(const ViewMap::Place& place, std::int32_t i, float radius_m, float cell_m,
              std::vector<float>& cost);

    OrientedPoints surface_;
    std::vector<float> depth_m_;
    std::vector<char> border_;
    int first_column_ = 0, first_row_ = 0, width_ = 0, height_ = 0;
    std::vector<std::int32_t> index_;
};

}  // namespace gripscan
