// What belongs to the 3D view alone: where the user looks from and what is switched on.
#pragma once

#include <array>
#include <optional>

#include "ui/layout/rect.h"
#include "ui/render/box_handles.h"
#include "ui/render/orbit_camera.h"
#include "ui/theme/colour_by.h"
#include "ui/views/colouring_text.h"
#include "ui/views/cursor_reading.h"
#include "ui/views/measuring.h"

namespace gripscan::ui {

/// A drag that began in the scene and has not ended.
struct ViewDrag {
    enum class What { kNone, kPoint, kOrbit, kPan, kZoom, kFace } what = What::kNone;
    int button = 0;  ///< of Dear ImGui
    Rect rect;       ///< the half of the view in which it began
    BoxDrag face;
    double travelled_px = 0.0;  ///< a press that hardly moved is a click
};

struct View3dState {
    OrbitCamera camera;
    bool looked = false;  ///< the camera has been fitted to something

    SceneWish wish;                     ///< the two clouds of a step, and how they stand
    std::optional<ColourBy> colour_by;  ///< nothing: what suits the scene
    std::array<std::optional<LegendRange>, 8> typed_ranges;  ///< by ColourBy
    float point_size_px = 2.0F;
    bool eye_dome = true;
    bool side_by_side = false;
    bool edit_box = true;      ///< handles of the crop cuboid
    bool edit_region = false;  ///< handles of the registration area
    bool show_cell = true;     ///< axis, areas, arm, camera
    Measuring measuring;
    bool photograph = false;  ///< without tools, with a caption: the frame that is captured

    std::optional<CursorReading> cursor;  ///< out: for the status bar
    Rect picture_rect;                    ///< out: what a photograph is cut from

    ViewDrag drag;
    bool clicked_before = false;  ///< the last press was no drag: the next may be a double click
    double pivot_shown_until_s = 0.0;
};

}  // namespace gripscan::ui
