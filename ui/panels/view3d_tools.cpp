#include "ui/panels/view3d_tools.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/panels/colour_menu.h"
#include "ui/panels/view3d_lines.h"
#include "ui/theme/shown_number.h"
#include "ui/widgets/button.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/number_input.h"

namespace gripscan::ui {
namespace {

constexpr float kLabelsFrom_px = 780.0F;  ///< narrower views do without words beside the tools

/// A row of things in a card, laid from the left.
class ToolCard {
  public:
    ToolCard(const Ui& ui, int x, int y, int width)
        : ui_(ui), rect_{x, y, width, ui.em(2.43F)}, x_(x + ui.em(0.57F)) {
        fill(rect_, ui.theme.panel, ui.scale.em(0.36F));
        outline(rect_, ui.theme.line, ui.scale.line(), ui.scale.em(0.36F));
    }
    [[nodiscard]] Rect next(float width_em, float height_em = 1.86F) {
        const int height = ui_.em(height_em);
        const Rect place{x_, rect_.y + (rect_.height - height) / 2, ui_.em(width_em), height};
        x_ = place.right() + ui_.em(0.14F);
        return place;
    }
    void gap(float width_em) { x_ += ui_.em(width_em); }
    void label(std::string_view text) {
        x_ = static_cast<int>(draw_text(ui_, static_cast<float>(x_) + ui_.scale.em(0.29F), middle(),
                                        FontRole::kTable, ui_.theme.text_second, text)) +
             ui_.em(0.43F);
    }
    void separator() {
        x_ += ui_.em(0.43F);
        const auto x = static_cast<float>(x_);
        draw_line(ui_, {x, static_cast<float>(rect_.y) + ui_.scale.em(0.5F)},
                  {x, static_cast<float>(rect_.bottom()) - ui_.scale.em(0.5F)}, ui_.theme.line2);
        x_ += ui_.em(0.43F);
    }
    [[nodiscard]] float middle() const {
        return static_cast<float>(rect_.y) + 0.5F * static_cast<float>(rect_.height);
    }
    [[nodiscard]] int x() const { return x_; }

  private:
    const Ui& ui_;
    Rect rect_;
    int x_;
};

void draw_size(const Ui& ui, ToolCard& card, View3dState& state, bool labels) {
    if (labels) card.label("Size");
    const auto step = [&](double by) {
        state.point_size_px =
            static_cast<float>(std::clamp(std::round(state.point_size_px + by), 1.0, 10.0));
    };
    ButtonSpec less{"view3d.smaller", "−", Icon::kNone};
    less.tooltip = "Smaller points";
    if (state.point_size_px <= 1.0F) less.why_disabled = "1 px is the smallest point";
    if (button(ui, card.next(1.57F), less)) step(-1.0);
    const auto typed = number_input(
        ui, card.next(4.0F),
        {"view3d.point_size", "Point size", state.point_size_px, "px", 1, 1.0, 10.0, {}});
    if (typed.committed) state.point_size_px = static_cast<float>(*typed.committed);
    ButtonSpec more{"view3d.larger", "+", Icon::kNone};
    more.tooltip = "Larger points";
    if (state.point_size_px >= 10.0F) more.why_disabled = "10 px is the largest point";
    if (button(ui, card.next(1.57F), more)) step(1.0);
}

bool tool(const Ui& ui, ToolCard& card, std::string_view id, Icon icon, std::string_view tooltip,
          bool on, std::string_view why_disabled = {}) {
    ButtonSpec spec{id, {}, icon};
    spec.tooltip = tooltip;
    spec.chosen = on;
    spec.why_disabled = why_disabled;
    return icon_button(ui, card.next(2.14F, 2.14F), spec).clicked;
}

void draw_left(const Ui& ui, const Rect& rect, const SceneParts& parts, const Snapshot& snapshot,
               View3dState& state, bool labels) {
    const int width = ui.em(labels ? 33.4F : 28.0F);
    ToolCard card(ui, rect.x + ui.em(0.71F), rect.y + ui.em(0.71F), width);
    if (labels) card.label("Colour");
    draw_colour_menu(ui, card.next(7.2F), snapshot, parts, state);
    card.separator();
    draw_size(ui, card, state, labels);
    card.separator();
    const std::string no_cloud =
        parts.kind == SceneKind::kEmpty ? "there is no cloud yet" : std::string();
    if (tool(ui, card, "view3d.measure", Icon::kRuler, "Measure between two points",
             state.measuring.on, no_cloud)) {
        state.measuring = {!state.measuring.on, {}};
    }
    const bool crops = parts.kind == SceneKind::kTemplate;
    bool& handles = crops ? state.edit_box : state.edit_region;
    const std::string no_box = crops ? std::string() : why_no_region_box(snapshot, parts);
    if (tool(ui, card, "view3d.crop", Icon::kCrop,
             crops ? "Handles of the crop cuboid"
                   : "Handles of the registration area; the Cell page keeps what is changed",
             handles && no_box.empty(), no_box)) {
        handles = !handles;
    }
    if (tool(ui, card, "view3d.eye_dome", Icon::kLightbulb, "Eye-dome lighting: edges stand out",
             state.eye_dome)) {
        state.eye_dome = !state.eye_dome;
    }
    if (tool(ui, card, "view3d.side_by_side", Icon::kCompare, "Side by side, with linked views",
             state.side_by_side, why_no_side_by_side(parts))) {
        state.side_by_side = !state.side_by_side;
    }
}

std::optional<ViewCommand> draw_right(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                                      const SceneParts& parts, View3dState& state, bool labels,
                                      Requests& out) {
    const std::string points = shown_count(static_cast<long long>(visible_points(parts)));
    const std::string words = labels ? points + " points" : std::string();
    const float wide =
        labels ? text_width(ui, FontRole::kNumberTable, words) + ui.scale.em(1.3F) : 0.0F;
    const int width = static_cast<int>(wide) + ui.em(0.86F) + 5 * (ui.em(2.14F) + ui.em(0.14F));
    ToolCard card(ui, rect.right() - ui.em(0.71F) - width, rect.y + ui.em(0.71F), width);
    if (labels) {
        const float x = static_cast<float>(card.x()) + ui.scale.em(0.29F);
        const float end =
            draw_text(ui, x, card.middle(), FontRole::kNumberTable, ui.theme.text_second, words);
        card.gap((end - static_cast<float>(card.x())) / ui.scale.em(1.0F));
        card.separator();
    }
    std::optional<ViewCommand> command;
    const std::string fit =
        labels ? "Fit everything (Home)" : "Fit everything: " + points + " points";
    if (tool(ui, card, "view3d.fit", Icon::kFit, fit, false)) command = ViewCommand::kFitAll;
    if (tool(ui, card, "view3d.along_axis", Icon::kRotateLeft, "Look along the joint axis", false,
             snapshot.cell.axis ? "" : "the axis is not known yet")) {
        command = ViewCommand::kAlongAxis;
    }
    if (tool(ui, card, "view3d.stereo_camera", Icon::kTarget, "View of the left camera", false,
             snapshot.session ? "" : "no session is open")) {
        command = ViewCommand::kStereoCamera;
    }
    if (tool(ui, card, "view3d.cell", Icon::kCube, "The cell around the part: axis, areas, arm",
             state.show_cell)) {
        state.show_cell = !state.show_cell;
    }
    if (tool(ui, card, "view3d.screenshot", Icon::kCamera, "Picture of the view with a scale bar",
             false)) {
        out.emplace_back(request::Screenshot{true});
    }
    return command;
}

}  // namespace

std::string why_no_side_by_side(const SceneParts& parts) {
    const auto visible = std::count_if(parts.clouds.begin(), parts.clouds.end(),
                                       [](const SceneCloud& cloud) { return cloud.visible; });
    return visible >= 2 ? "" : "two clouds are needed";
}

std::optional<ViewCommand> draw_view3d_tools(const Ui& ui, const Rect& rect,
                                             const Snapshot& snapshot, const SceneParts& parts,
                                             View3dState& state, Requests& out) {
    const bool labels = static_cast<float>(rect.width) / ui.scale.factor() >= kLabelsFrom_px;
    draw_left(ui, rect, parts, snapshot, state, labels);
    return draw_right(ui, rect, snapshot, parts, state, labels, out);
}

}  // namespace gripscan::ui
