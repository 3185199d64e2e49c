// The images of the stereo panel: textures, and one image in its frame with zoom, ruler and area.
#pragma once

#include "ui/gl/image_texture.h"
#include "ui/panels/stereo_panel.h"
#include "ui/views/stereo_facts.h"

namespace gripscan::ui {

struct StereoTextures::Parts {
    std::shared_ptr<const StereoPicture> uploaded;  ///< held, so that its address stays its own
    DisparityRange range;
    ImageTexture left;
    ImageTexture right;
    ImageTexture disparity;

    /// Uploads what is new; the disparity's colours follow the range.
    void show(const std::shared_ptr<const StereoPicture>& picture, const CellFrame& cell,
              const Colour& unknown);
};

enum class StereoImage { kLeft, kRight, kDisparity };

/// One image on the screen.
struct ImagePlace {
    StereoImage which = StereoImage::kLeft;
    Rect rect;
    std::string_view id;         ///< "stereo.left"
    std::string_view name = {};  ///< "Left"; empty: it goes without saying
    bool ruler = false;          ///< a row through it; its text stands in the right image
    std::optional<double> row_error_px = {};
};

/// Draws it and takes the mouse: wheel zooms, drag moves, the ruler follows. Returns the read-out
/// of the pixel under the mouse; empty: it is not over the image.
[[nodiscard]] std::string draw_stereo_image(const Ui& ui, const ImagePlace& place,
                                            const StereoPicture& picture, const CellFrame& cell,
                                            StereoTextures::Parts* textures,
                                            StereoPanelState& local);

}  // namespace gripscan::ui
