// Which part of an image is seen in a frame on the screen. Pure.
#pragma once

#include <Eigen/Core>

namespace gripscan::ui {

/// The whole image fits at zoom 1.
struct ImageZoom {
    double zoom = 1.0;      ///< 1 … 32
    double centre_x = 0.5;  ///< what lies in the middle, as a part of the image's width
    double centre_y = 0.5;
    friend bool operator==(const ImageZoom&, const ImageZoom&) = default;
};

/// A frame of so many px with an image of so many px in it.
struct ImageFrame {
    Eigen::Vector2d frame_px = Eigen::Vector2d::Ones();
    Eigen::Vector2d image_px = Eigen::Vector2d::Ones();

    /// Screen px of one image px.
    [[nodiscard]] double scale(const ImageZoom& zoom) const;
    /// From image to frame and back; the corner of pixel (0, 0) is (0, 0).
    [[nodiscard]] Eigen::Vector2d to_frame(const ImageZoom& zoom,
                                           const Eigen::Vector2d& image) const;
    [[nodiscard]] Eigen::Vector2d to_image(const ImageZoom& zoom,
                                           const Eigen::Vector2d& frame) const;
};

/// The wheel: what lies under the cursor stays there. Whole images stay in the middle.
[[nodiscard]] ImageZoom zoomed_at(const ImageZoom& zoom, double clicks, const Eigen::Vector2d& at,
                                  const ImageFrame& frame);
/// A drag: the image follows the mouse, as far as there is image.
[[nodiscard]] ImageZoom moved_by(const ImageZoom& zoom, const Eigen::Vector2d& by_px,
                                 const ImageFrame& frame);

}  // namespace gripscan::ui
