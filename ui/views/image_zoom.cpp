#include "ui/views/image_zoom.h"

#include <algorithm>
#include <cmath>

namespace gripscan::ui {
namespace {

constexpr double kMost = 32.0;
constexpr double kPerClick = 1.25;

/// Keeps the frame filled: no border comes in while the image is larger than it.
ImageZoom kept_inside(ImageZoom zoom, const ImageFrame& frame) {
    const Eigen::Vector2d seen = frame.frame_px / frame.scale(zoom);  // image px across the frame
    const auto keep = [](double centre, double part) {
        const double half = 0.5 * part;
        return half >= 0.5 ? 0.5 : std::clamp(centre, half, 1.0 - half);
    };
    zoom.centre_x = keep(zoom.centre_x, seen.x() / frame.image_px.x());
    zoom.centre_y = keep(zoom.centre_y, seen.y() / frame.image_px.y());
    return zoom;
}

}  // namespace

double ImageFrame::scale(const ImageZoom& zoom) const {
    return zoom.zoom * (frame_px.array() / image_px.array()).minCoeff();
}

Eigen::Vector2d ImageFrame::to_frame(const ImageZoom& zoom, const Eigen::Vector2d& image) const {
    const Eigen::Vector2d centre(zoom.centre_x * image_px.x(), zoom.centre_y * image_px.y());
    return 0.5 * frame_px + scale(zoom) * (image - centre);
}

Eigen::Vector2d ImageFrame::to_image(const ImageZoom& zoom, const Eigen::Vector2d& frame) const {
    const Eigen::Vector2d centre(zoom.centre_x * image_px.x(), zoom.centre_y * image_px.y());
    return centre + (frame - 0.5 * frame_px) / scale(zoom);
}

ImageZoom zoomed_at(const ImageZoom& zoom, double clicks, const Eigen::Vector2d& at,
                    const ImageFrame& frame) {
    const Eigen::Vector2d held = frame.to_image(zoom, at);
    ImageZoom next = zoom;
    next.zoom = std::clamp(zoom.zoom * std::pow(kPerClick, clicks), 1.0, kMost);
    const Eigen::Vector2d now = frame.to_image(next, at);
    next.centre_x += (held.x() - now.x()) / frame.image_px.x();
    next.centre_y += (held.y() - now.y()) / frame.image_px.y();
    return kept_inside(next, frame);
}

ImageZoom moved_by(const ImageZoom& zoom, const Eigen::Vector2d& by_px, const ImageFrame& frame) {
    ImageZoom next = zoom;
    const Eigen::Vector2d image = by_px / frame.scale(zoom);
    next.centre_x -= image.x() / frame.image_px.x();
    next.centre_y -= image.y() / frame.image_px.y();
    return kept_inside(next, frame);
}

}  // namespace gripscan::ui
