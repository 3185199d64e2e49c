// What stands over the picture of the scene: words at places, handles, measured points, scale bar,
// triad.
#pragma once

#include "ui/panels/view3d_lines.h"
#include "ui/render/box_handles.h"
#include "ui/views/measuring.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// One line with an outline that keeps it readable over points. Returns the x where it ends.
float draw_outlined(const Ui& ui, float x, float y, const Colour& colour, std::string_view text,
                    bool ends_there = false);

void draw_labels(const Ui& ui, const Rect& rect, const OrbitCamera& camera,
                 const std::vector<SceneLabel>& labels);
void draw_handles(const Ui& ui, const Rect& rect, const Box& box, const OrbitCamera& camera,
                  const std::optional<BoxFace>& dragged);
void draw_measured(const Ui& ui, const Rect& rect, const Measuring& measuring,
                   const OrbitCamera& camera);
/// At the lower right corner; returns the left end.
int draw_triad(const Ui& ui, const Rect& rect, const OrbitCamera& camera);
void draw_scale_bar(const Ui& ui, int right, const Rect& rect, const OrbitCamera& camera);
/// In the middle.
void draw_message(const Ui& ui, const Rect& rect, std::string_view title, std::string_view text);

}  // namespace gripscan::ui
