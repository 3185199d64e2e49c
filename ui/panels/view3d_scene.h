// From the parts of the scene to what the renderer takes, and the cameras of the view's commands.
#pragma once

#include <span>

#include "ui/panels/view3d_state.h"
#include "ui/render/cloud_view.h"
#include "ui/render/picking.h"
#include "ui/views/view_keys.h"

namespace gripscan::ui {

/// Which clouds a half of the view shows: of a step target and source, else all but the last and
/// the last.
enum class PaneContent { kAll, kFirst, kSecond };
[[nodiscard]] std::vector<PointChunk> chunks_of(const SceneParts& parts, PaneContent content,
                                                const Theme& theme);

/// Around the visible clouds, in the world; not valid where there are none. Of large clouds from
/// their samples: it may miss single points.
[[nodiscard]] Box bounds_of_scene(const SceneParts& parts);
/// With the registration area.
[[nodiscard]] Box whole_scene(const Snapshot& snapshot, const Box& bounds);

/// From the front, above and the right of it.
[[nodiscard]] OrbitCamera first_look(const Box& around, const Viewport& viewport);
/// The camera after a command; the same one after those that are about something else.
[[nodiscard]] OrbitCamera commanded(const OrbitCamera& camera, ViewCommand command,
                                    const Snapshot& snapshot, const Box& bounds,
                                    const Viewport& viewport);

[[nodiscard]] ViewSettings view_settings(ColourBy by, const LegendRange& range,
                                         const Snapshot& snapshot, const SceneParts& parts,
                                         const View3dState& state);

/// The point under a pixel; looks at a sample where there are very many.
[[nodiscard]] std::optional<PickedPoint> pick_in(std::span<const PointChunk> chunks,
                                                 const OrbitCamera& camera,
                                                 const Viewport& viewport,
                                                 const Eigen::Vector2d& px, Scale scale);
[[nodiscard]] CursorReading reading_of(const PickedPoint& point,
                                       std::span<const PointChunk> chunks);

/// Ranges that suit the points, computed when they change.
class RangeCache {
  public:
    /// The typed range where there is one, in the unit of the colouring.
    [[nodiscard]] LegendRange range(ColourBy by, const SceneParts& parts, int min_seen,
                                    const View3dState& state);

  private:
    struct Key {
        ColourBy by = ColourBy::kChunk;
        int min_seen = 0;
        int steps_total = 0;
        std::vector<std::pair<std::uint64_t, std::uint64_t>> clouds;
        friend bool operator==(const Key&, const Key&) = default;
    };
    Key key_;
    LegendRange range_;
};

}  // namespace gripscan::ui
