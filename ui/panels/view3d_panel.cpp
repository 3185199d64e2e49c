#include "ui/panels/view3d_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/imgui_compat.h"
#include "ui/panels/colour_menu.h"
#include "ui/panels/view3d_gestures.h"
#include "ui/panels/view3d_legend.h"
#include "ui/panels/view3d_lines.h"
#include "ui/panels/view3d_overlays.h"
#include "ui/panels/view3d_scene.h"
#include "ui/panels/view3d_tools.h"
#include "ui/views/scene_words.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/key_press.h"

namespace gripscan::ui {
namespace {

constexpr double kPivotShown_s = 1.2;

Rect half_of(const Ui& ui, const Rect& rect, int which) {
    const int gap = ui.px(2);
    const int left = (rect.width - gap) / 2;
    return which == 0 ? Rect{rect.x, rect.y, left, rect.height}
                      : Rect{rect.x + left + gap, rect.y, rect.width - left - gap, rect.height};
}

/// The cuboid while its handles are shown.
std::optional<Box> box_with_handles(const Snapshot& snapshot, const SceneParts& parts,
                                    const Box& around, const View3dState& local) {
    const bool shown = parts.kind == SceneKind::kEmpty ? local.edit_region : local.edit_box;
    return shown ? editable_box(snapshot, parts, around) : std::nullopt;
}

void draw_texture(const Rect& rect, unsigned int texture) {
    // The first row of the texture is at the bottom.
    ImGui::GetWindowDrawList()->AddImage(
        imgui_texture(texture), {static_cast<float>(rect.x), static_cast<float>(rect.y)},
        {static_cast<float>(rect.right()), static_cast<float>(rect.bottom())}, {0.0F, 1.0F},
        {1.0F, 0.0F});
}

}  // namespace

struct View3d::Parts {
    struct Pane {
        std::unique_ptr<CloudView> view;
        Rect rect;
        std::vector<PointChunk> chunks;
    };
    std::array<Pane, 2> panes;
    std::size_t panes_shown = 1;
    SceneParts scene;  ///< held, so that what names the template stays unique
    Box bounds;        ///< of what is visible
    RangeCache ranges;
    std::string trouble;    ///< of the drawing
    bool animates = false;  ///< something that will go away by itself is shown
    std::pair<std::size_t, bool> selection{0, true};
};

View3d::View3d() : parts_(std::make_unique<Parts>()) {}
View3d::~View3d() = default;

Result<std::unique_ptr<View3d>> View3d::make() {
    std::unique_ptr<View3d> view(new View3d());
    for (auto& pane : view->parts_->panes) {
        auto made = CloudView::make();
        if (!made) return forward_error(made.error());
        pane.view = *std::move(made);
    }
    return view;
}

void View3d::lay_out(const Ui& ui, const Rect& rect, const Snapshot& snapshot, View3dState& local) {
    Parts& parts = *parts_;
    // Another step was chosen: whether its two clouds are shown is for that step to say.
    const std::pair selection{snapshot.selected_row, snapshot.follows_last};
    if (std::exchange(parts.selection, selection) != selection) local.wish.pair.reset();
    parts.scene = scene_parts(snapshot, local.wish);
    parts.bounds = bounds_of_scene(parts.scene);
    const bool two = local.side_by_side && why_no_side_by_side(parts.scene).empty();
    parts.panes_shown = two ? 2 : 1;
    for (std::size_t i = 0; i < parts.panes_shown; ++i) {
        parts.panes[i].rect = two ? half_of(ui, rect, static_cast<int>(i)) : rect;
        const PaneContent content = !two     ? PaneContent::kAll
                                    : i == 0 ? PaneContent::kFirst
                                             : PaneContent::kSecond;
        parts.panes[i].chunks = chunks_of(parts.scene, content, ui.theme);
    }
    if (!local.looked) {
        const Box around = whole_scene(snapshot, parts.bounds);
        if (around.valid()) {
            local.camera = first_look(around, viewport_of(parts.panes[0].rect));
            local.looked = true;
        }
    }
}

void View3d::take_input(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                        View3dState& local, Requests& out) {
    Parts& parts = *parts_;
    const SceneMouse mouse = read_mouse(ui, rect, local.drag);
    const auto x = static_cast<int>(mouse.at_px.x());
    const auto y = static_cast<int>(mouse.at_px.y());
    const Parts::Pane* pane = &parts.panes[0];
    if (parts.panes_shown == 2 && parts.panes[1].rect.contains(x, y)) pane = &parts.panes[1];
    const Rect target_rect =
        local.drag.what != ViewDrag::What::kNone ? local.drag.rect : pane->rect;
    const auto pick = [&](const Eigen::Vector2d& px) {
        return pick_in(pane->chunks, local.camera, viewport_of(pane->rect), px, ui.scale);
    };
    const auto box = box_with_handles(snapshot, parts.scene, parts.bounds, local);
    const auto result = take_mouse(mouse,
                                   {target_rect, snapshot.preferences.navigation, box,
                                    static_cast<double>(ui.scale.px(7.0F)), pick},
                                   local);
    if (result.box && parts.scene.kind == SceneKind::kEmpty) {
        out.emplace_back(request::SetRegion{result.box});
    } else if (result.box) {
        TemplateFilter filter = snapshot.filter;
        filter.crop = result.box;
        out.emplace_back(request::SetFilter{filter});
    }
    if (result.pivot_chosen) local.pivot_shown_until_s = ui.time_s + kPivotShown_s;
    const bool reads = mouse.hovered && local.drag.what == ViewDrag::What::kNone;
    const auto under =
        reads ? pick(mouse.at_px - Eigen::Vector2d(pane->rect.x, pane->rect.y)) : std::nullopt;
    local.cursor = under ? std::optional(reading_of(*under, pane->chunks)) : std::nullopt;
    if (snapshot.dialog != Dialog::kNone) return;
    for (const std::string& key : command_keys()) take_key(key, snapshot, local);
}

void View3d::draw_scene(const Ui& ui, const Snapshot& snapshot, View3dState& local, Requests& out,
                        double last_frame_ms) {
    Parts& parts = *parts_;
    const ColourBy by = shown_colouring(parts.scene, local);
    const bool residuals = by == ColourBy::kResidual;
    if (residuals != snapshot.residuals_wanted) out.emplace_back(request::WantResiduals{residuals});
    const LegendRange range = parts.ranges.range(by, parts.scene, snapshot.filter.min_seen, local);
    const bool pivot =
        ui.time_s < local.pivot_shown_until_s || local.drag.what == ViewDrag::What::kOrbit;
    parts.animates = ui.time_s < local.pivot_shown_until_s;
    for (std::size_t i = 0; i < parts.panes_shown; ++i) {
        Parts::Pane& pane = parts.panes[i];
        const SceneLines lines = scene_lines(
            {snapshot, parts.scene, ui.theme, local.camera, viewport_of(pane.rect), parts.bounds,
             static_cast<double>(ui.scale.factor()), local.show_cell, local.edit_region,
             pivot ? std::optional(local.camera.pivot_m) : std::nullopt});
        const auto drawn = pane.view->draw({pane.chunks, &lines.lines, local.camera,
                                            view_settings(by, range, snapshot, parts.scene, local)},
                                           pane.rect.width, pane.rect.height, ui.theme, ui.scale,
                                           i == 0 ? last_frame_ms : 0.0);
        parts.trouble = drawn ? std::string() : drawn.error().message;
        if (!drawn) return;
        draw_texture(pane.rect, pane.view->texture());
        ImGui::PushClipRect(
            {static_cast<float>(pane.rect.x), static_cast<float>(pane.rect.y)},
            {static_cast<float>(pane.rect.right()), static_cast<float>(pane.rect.bottom())}, true);
        draw_labels(ui, pane.rect, local.camera, lines.labels);
        const auto box = box_with_handles(snapshot, parts.scene, parts.bounds, local);
        if (box && !local.photograph) {
            draw_handles(ui, pane.rect, *box, local.camera,
                         local.drag.what == ViewDrag::What::kFace
                             ? std::optional(local.drag.face.face)
                             : std::nullopt);
        }
        draw_measured(ui, pane.rect, local.measuring, local.camera);
        ImGui::PopClipRect();
    }
}

void View3d::draw_overlays(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                           View3dState& local, Requests& out) {
    Parts& parts = *parts_;
    const int left_of_triad = draw_triad(ui, rect, local.camera);
    if (parts.scene.kind != SceneKind::kEmpty) {
        draw_scale_bar(ui, left_of_triad, rect, local.camera);
    }
    const ColourBy by = shown_colouring(parts.scene, local);
    const LegendRange range = parts.ranges.range(by, parts.scene, snapshot.filter.min_seen, local);
    const bool ghost = local.show_cell && snapshot.cell.axis && parts.scene.turn.next_rad;
    draw_view3d_legend(ui, rect, {parts.scene, by, range, ghost}, local);
    if (local.measuring.on) draw_measure_card(ui, rect, snapshot, local.measuring);
    if (local.photograph) {
        draw_outlined(ui, static_cast<float>(rect.x) + ui.scale.em(1.0F),
                      static_cast<float>(rect.y) + ui.scale.em(1.3F), ui.theme.text,
                      scene_caption(snapshot, parts.scene));
        return;
    }
    if (const auto command = draw_view3d_tools(ui, rect, snapshot, parts.scene, local, out)) {
        obey(*command, snapshot, local);
    }
    const bool edits = box_with_handles(snapshot, parts.scene, parts.bounds, local).has_value();
    if (parts.scene.kind == SceneKind::kEmpty && !edits) {
        const EmptyText text = empty_scene_text(snapshot);
        draw_message(ui, rect, text.title, text.what_to_do);
    }
}

void View3d::draw(const Ui& ui, const Rect& rect, const Snapshot& snapshot, View3dState& local,
                  Requests& out, double last_frame_ms) {
    if (rect.empty()) return;
    local.picture_rect = rect;
    lay_out(ui, rect, snapshot, local);
    take_input(ui, rect, snapshot, local, out);
    draw_scene(ui, snapshot, local, out, last_frame_ms);
    if (!parts_->trouble.empty()) {
        fill(rect, ui.theme.view_bottom);
        draw_message(ui, rect, "The 3D view cannot be drawn", parts_->trouble);
        return;
    }
    draw_overlays(ui, rect, snapshot, local, out);
}

void View3d::obey(ViewCommand command, const Snapshot& snapshot, View3dState& local) {
    const Parts& parts = *parts_;
    local.camera =
        commanded(local.camera, command, snapshot, parts.bounds, viewport_of(parts.panes[0].rect));
    const bool any = parts.scene.kind != SceneKind::kEmpty;
    if (command == ViewCommand::kMeasure && any) local.measuring = {!local.measuring.on, {}};
    if (command == ViewCommand::kSideBySide && why_no_side_by_side(parts.scene).empty()) {
        local.side_by_side = !local.side_by_side;
    }
    if (command == ViewCommand::kEyeDome) local.eye_dome = !local.eye_dome;
    const float by = command == ViewCommand::kLarger    ? 1.0F
                     : command == ViewCommand::kSmaller ? -1.0F
                                                        : 0.0F;
    local.point_size_px = std::clamp(local.point_size_px + by, 1.0F, 10.0F);
}

bool View3d::take_key(std::string_view key, const Snapshot& snapshot, View3dState& local) {
    if (key == "Esc" && local.measuring.on) {
        local.measuring = {};
        return true;
    }
    const auto command = view_command(key, snapshot.preferences);
    if (command) obey(*command, snapshot, local);
    return command.has_value();
}

bool View3d::complete() const {
    const Parts& parts = *parts_;
    return !parts.animates &&
           std::all_of(parts.panes.begin(),
                       parts.panes.begin() + static_cast<long>(parts.panes_shown),
                       [](const Parts::Pane& pane) { return pane.view->complete(); });
}

}  // namespace gripscan::ui
