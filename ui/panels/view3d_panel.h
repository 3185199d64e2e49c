// The 3D view as a panel: clouds, the cell around them, tools, legend. Draws, takes the mouse, and
// asks; what is shown comes from ui/views/scene_parts.
#pragma once

#include <memory>
#include <string_view>

#include "core/base/result.h"
#include "ui/layout/rect.h"
#include "ui/panels/view3d_state.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/views/view_keys.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

class View3d {
  public:
    /// Needs a current OpenGL context, here and until its end.
    [[nodiscard]] static Result<std::unique_ptr<View3d>> make();
    ~View3d();
    View3d(const View3d&) = delete;
    View3d& operator=(const View3d&) = delete;

    /// `last_frame_ms`: the whole frame before (0: unknown); how many points a moving view draws
    /// follows from it. On the Template page the crop cuboid can be dragged: request::SetFilter.
    void draw(const Ui& ui, const Rect& rect, const Snapshot& snapshot, View3dState& local,
              Requests& out, double last_frame_ms = 0.0);

    /// A key of the view, as text ("F", "Ctrl+1"); false: it is none of its keys.
    bool take_key(std::string_view key, const Snapshot& snapshot, View3dState& local);

    /// Nothing is left to draw: no frame is needed until something changes.
    [[nodiscard]] bool complete() const;

  private:
    View3d();
    void lay_out(const Ui& ui, const Rect& rect, const Snapshot& snapshot, View3dState& local);
    void take_input(const Ui& ui, const Rect& rect, const Snapshot& snapshot, View3dState& local,
                    Requests& out);
    void draw_scene(const Ui& ui, const Snapshot& snapshot, View3dState& local, Requests& out,
                    double last_frame_ms);
    void draw_overlays(const Ui& ui, const Rect& rect, const Snapshot& snapshot, View3dState& local,
                       Requests& out);
    void obey(ViewCommand command, const Snapshot& snapshot, View3dState& local);

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace gripscan::ui
