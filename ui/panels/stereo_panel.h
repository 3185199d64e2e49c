// The stereo images beside the 3D view: left and right or left and disparity, with linked zoom, a
// row ruler through both, the registration area, and what was measured in it.
#pragma once

#include <memory>

#include "ui/layout/rect.h"
#include "ui/views/image_zoom.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// The images on the graphics card; uploaded only when they change. Needs a current OpenGL context
/// from the first use until its end.
class StereoTextures {
  public:
    StereoTextures();
    ~StereoTextures();
    StereoTextures(const StereoTextures&) = delete;
    StereoTextures& operator=(const StereoTextures&) = delete;

    struct Parts;
    [[nodiscard]] Parts& parts();

  private:
    std::unique_ptr<Parts> parts_;
};

struct StereoPanelState {
    bool disparity = false;  ///< instead of the right image
    bool linked = true;      ///< both are zoomed and moved together
    ImageZoom first;
    ImageZoom second;
    double ruler = 0.55;  ///< row, as a part of the height; follows the mouse over an image
};

/// `textures` null: only the words are drawn (no OpenGL).
void draw_stereo_panel(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                       StereoTextures* textures, StereoPanelState& local, Requests& out);

}  // namespace gripscan::ui
