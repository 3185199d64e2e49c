#include "ui/render/line_batch.h"

#include <cmath>

namespace gripscan::ui {
namespace {

struct ScreenPoint {
    Eigen::Vector2d px;
    double depth;
};

ScreenPoint on_screen(const Eigen::Vector4d& clip, const Viewport& viewport) {
    const Eigen::Vector3d ndc = clip.head<3>() / clip.w();
    return {{(ndc.x() + 1.0) * 0.5 * viewport.width_px, (1.0 - ndc.y()) * 0.5 * viewport.height_px},
            0.5 * (ndc.z() + 1.0)};
}

/// Cuts what lies before the near plane (clip z < −w); false if nothing is left.
bool cut_at_near_plane(Eigen::Vector4d& a, Eigen::Vector4d& b) {
    const double da = a.z() + a.w();
    const double db = b.z() + b.w();
    if (da <= 0.0 && db <= 0.0) return false;
    if (da < 0.0) a += (b - a) * (da / (da - db));
    if (db < 0.0) b += (a - b) * (db / (db - da));
    return a.w() > 0.0 && b.w() > 0.0;
}

LineVertex corner(const ScreenPoint& at, const Eigen::Vector2d& side, double across, double along,
                  const LineStyle& style, float scale) {
    LineVertex v{};
    v.x_px = static_cast<float>(at.px.x() + side.x() * across);
    v.y_px = static_cast<float>(at.px.y() + side.y() * across);
    v.depth = static_cast<float>(at.depth);
    v.along_px = static_cast<float>(along);
    v.across_px = static_cast<float>(across);
    v.half_width_px = 0.5F * style.width_px * scale;
    v.colour = style.colour.packed();
    v.hidden = static_cast<float>(style.hidden);
    for (std::size_t i = 0; i < 4; ++i) v.dash_px[i] = style.dash_px[i] * scale;
    return v;
}

/// Appends the piece; returns its length in px.
double add_piece(std::vector<LineVertex>& vertices, const ScreenPoint& a, const ScreenPoint& b,
                 double along, const LineStyle& style, float scale) {
    const Eigen::Vector2d d = b.px - a.px;
    const double length = d.norm();
    if (length < 1e-6 || !std::isfinite(length)) return 0.0;
    const Eigen::Vector2d side(-d.y() / length, d.x() / length);
    const double reach = 0.5 * static_cast<double>(style.width_px * scale) + 1.0;  // soft edge
    const LineVertex a0 = corner(a, side, -reach, along, style, scale);
    const LineVertex a1 = corner(a, side, reach, along, style, scale);
    const LineVertex b0 = corner(b, side, -reach, along + length, style, scale);
    const LineVertex b1 = corner(b, side, reach, along + length, style, scale);
    vertices.insert(vertices.end(), {a0, b0, a1, a1, b0, b1});
    return length;
}

}  // namespace

void LineBatch::clear() {
    points_.clear();
    polylines_.clear();
}

void LineBatch::segment(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m,
                        const LineStyle& style) {
    const std::array<Eigen::Vector3d, 2> ends{a_m, b_m};
    polyline(ends, style);
}

void LineBatch::polyline(std::span<const Eigen::Vector3d> points_m, const LineStyle& style) {
    polylines_.push_back({points_.size(), points_m.size(), style});
    points_.insert(points_.end(), points_m.begin(), points_m.end());
}

std::vector<LineVertex> line_vertices(const LineBatch& lines, const OrbitCamera& camera,
                                      const Viewport& viewport, const ClipRange& range,
                                      float scale) {
    const Eigen::Matrix4d M = clip_from_world(camera, viewport, range);
    std::vector<LineVertex> vertices;
    for (const LineBatch::Polyline& line : lines.polylines()) {
        double along = 0.0;
        for (std::size_t i = line.first; i + 1 < line.first + line.count; ++i) {
            Eigen::Vector4d a = M * lines.points()[i].homogeneous();
            Eigen::Vector4d b = M * lines.points()[i + 1].homogeneous();
            if (!cut_at_near_plane(a, b)) continue;
            along += add_piece(vertices, on_screen(a, viewport), on_screen(b, viewport), along,
                               line.style, scale);
        }
    }
    return vertices;
}

}  // namespace gripscan::ui
