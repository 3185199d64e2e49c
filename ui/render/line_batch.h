// Lines of the 3D view, laid out in pixels: widths and dashes keep their size whatever the
// distance, and hidden parts stay visible in a weaker style.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "ui/render/orbit_camera.h"
#include "ui/theme/colour.h"

namespace gripscan::ui {

enum class HiddenStyle {
    kFaint,   ///< behind the cloud: 25 %
    kDotted,  ///< behind the cloud: dotted
    kGone,    ///< behind the cloud: not drawn
    kSame,    ///< always on top
};

struct LineStyle {
    Colour colour{};
    float width_px = 1.0F;
    std::array<float, 4> dash_px{};  ///< on, off, on, off; all zero: solid
    HiddenStyle hidden = HiddenStyle::kFaint;
    friend bool operator==(const LineStyle&, const LineStyle&) = default;
};

class LineBatch {
  public:
    void clear();
    void segment(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m, const LineStyle& style);
    /// Dashes run on through its corners.
    void polyline(std::span<const Eigen::Vector3d> points_m, const LineStyle& style);

    struct Polyline {
        std::size_t first;
        std::size_t count;
        LineStyle style;
        friend bool operator==(const Polyline&, const Polyline&) = default;
    };
    [[nodiscard]] const std::vector<Eigen::Vector3d>& points() const { return points_; }
    [[nodiscard]] const std::vector<Polyline>& polylines() const { return polylines_; }
    friend bool operator==(const LineBatch&, const LineBatch&) = default;

  private:
    std::vector<Eigen::Vector3d> points_;
    std::vector<Polyline> polylines_;
};

/// A corner of the rectangle around a piece of a line.
struct LineVertex {
    float x_px, y_px;  ///< from the upper left corner
    float depth;       ///< OpenGL's, 0 … 1
    float along_px;    ///< from the beginning of the line
    float across_px;   ///< from its middle
    float half_width_px;
    std::uint32_t colour;
    float hidden;  ///< HiddenStyle as number
    float dash_px[4];
};

/// Two triangles a piece. What lies before the near plane is cut off.
[[nodiscard]] std::vector<LineVertex> line_vertices(const LineBatch& lines,
                                                    const OrbitCamera& camera,
                                                    const Viewport& viewport,
                                                    const ClipRange& range, float scale);

}  // namespace gripscan::ui
