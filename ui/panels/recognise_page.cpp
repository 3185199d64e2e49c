#include "ui/panels/recognise_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <vector>

#include "ui/panels/panel_parts.h"
#include "ui/panels/recognise_column.h"
#include "ui/panels/stereo_images.h"
#include "ui/panels/text_table.h"
#include "ui/panels/view3d_overlays.h"
#include "ui/theme/on_plate.h"
#include "ui/views/recognition_text.h"
#include "ui/widgets/button.h"
#include "ui/widgets/choice.h"

namespace gripscan::ui {
namespace {

constexpr float kHeader_em = 2.43F;

/// One found template over the image.
struct Overlay {
    const Ui& ui;
    const Rect& rect;
    ImageFrame frame;
    const ImageZoom& zoom;
    const RectifiedRig& rig;

    [[nodiscard]] std::optional<ImVec2> at(const Eigen::Vector3d& p_m) const {
        constexpr double kNearest_m = 0.01;
        if (p_m.z() < kNearest_m) return std::nullopt;
        const Eigen::Vector2d px = frame.to_frame(zoom, rig.project(p_m));
        return ImVec2{static_cast<float>(rect.x + px.x()), static_cast<float>(rect.y + px.y())};
    }
    void line(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m, const Colour& colour,
              float width_px) const {
        const auto a = at(a_m);
        const auto b = at(b_m);
        if (a && b) draw_line(ui, *a, *b, colour, ui.scale.px(width_px));
    }
    void box(const FoundTemplate& found, const Colour& colour) const {
        const auto corners = found.box.corners();
        for (unsigned i = 0; i < 8; ++i) {
            for (const unsigned side : {1U, 2U, 4U}) {
                if ((i & side) != 0) continue;
                line(found.T_camera_template * corners[i],
                     found.T_camera_template * corners[i | side], colour, 1.6F);
            }
        }
    }
    void frame_axes(const FoundTemplate& found) const {
        const Eigen::Vector3d middle = 0.5 * (found.box.min_m + found.box.max_m);
        const double length_m = 0.35 * (found.box.max_m - found.box.min_m).norm();
        const std::array colours{ui.theme.axis_x, ui.theme.axis_y, ui.theme.axis_z};
        for (int k = 0; k < 3; ++k) {
            line(found.T_camera_template * middle,
                 found.T_camera_template * (middle + length_m * Eigen::Vector3d::Unit(k)),
                 colours[static_cast<std::size_t>(k)], 2.4F);
        }
    }
    /// The nearest place above or below that overlaps none of those taken.
    [[nodiscard]] Rect free_place(const Rect& wanted, const std::vector<Rect>& taken) const {
        const auto is_free = [&](const Rect& place) {
            return place.y >= rect.y && place.bottom() <= rect.bottom() &&
                   std::ranges::none_of(taken,
                                        [&](const Rect& other) { return place.overlaps(other); });
        };
        const int step = wanted.height + ui.em(0.14F);
        for (int i = 0; i * step < rect.height; ++i) {
            for (const int way : {-1, 1}) {
                Rect place = wanted;
                place.y += way * i * step;
                if (is_free(place)) return place;
            }
        }
        return wanted;
    }
    /// Name and score above the highest corner; further up, else further down, where another label
    /// stands already.
    void label(const FoundTemplate& found, const Colour& colour, std::vector<Rect>& taken) const {
        std::optional<ImVec2> top;
        for (const Eigen::Vector3d& corner : found.box.corners()) {
            const auto px = at(found.T_camera_template * corner);
            if (px && (!top || px->y < top->y)) top = px;
        }
        if (!top) return;
        const std::string score = shown_number(found.score, 2);
        const float name_px = text_width(ui, FontRole::kTableStrong, found.name);
        const float score_px = text_width(ui, FontRole::kNumberTable, score);
        const float pad = ui.scale.em(0.57F);
        const int height = ui.em(1.71F);
        const auto width = static_cast<int>(name_px + score_px + 3.0F * pad);
        const int x = std::clamp(static_cast<int>(top->x) - width / 2, rect.x + ui.em(0.43F),
                                 std::max(rect.x, rect.right() - width - ui.em(0.43F)));
        const int y =
            std::max(rect.y + ui.em(0.43F), static_cast<int>(top->y) - height - ui.em(0.43F));
        const Rect plate = free_place({x, y, width, height}, taken);
        taken.push_back(plate);
        fill(plate, ui.theme.plate, ui.scale.em(0.21F));
        const float middle = middle_of(plate);
        const float end = draw_text(ui, static_cast<float>(x) + pad, middle, FontRole::kTableStrong,
                                    on_plate(ui.theme, colour), found.name);
        draw_text(ui, end + pad, middle, FontRole::kNumberTable, ui.theme.plate_text, score);
    }
};

void draw_image(const Ui& ui, const Rect& rect, const Snapshot& snapshot, StereoTextures* textures,
                RecognisePageState& local) {
    fill(rect, ui.theme.panel);
    const Rect head{rect.x, rect.y, rect.width, ui.em(kHeader_em)};
    const float middle = middle_of(head);
    float x = draw_text(ui, static_cast<float>(head.x) + ui.scale.em(0.86F), middle,
                        FontRole::kPanelTitle, ui.theme.text, "Image");
    const Rect picture{rect.x, head.bottom(), rect.width, rect.bottom() - head.bottom()};
    fill(picture, ui.theme.bg0);
    const auto& shown = snapshot.recognition;
    if (!shown || !shown->picture) {
        draw_message(ui, picture, shown ? "This view came as a cloud" : "No view yet",
                     shown ? "There is no image to draw into."
                           : "Capture one, or recognise a capture of the session.");
        return;
    }
    draw_text(ui, x + ui.scale.em(0.57F), middle, FontRole::kSmall, ui.theme.text_third,
              fitted(ui, FontRole::kSmall, view_words(*shown),
                     static_cast<float>(head.right()) - x - ui.scale.em(9.0F)));
    const std::array<Option, 2> options{{{"recognise.left", "Left"}, {"recognise.depth", "Depth"}}};
    const int choice_width = ui.em(8.0F);
    const Rect choice{head.right() - choice_width - ui.em(0.43F),
                      head.y + (head.height - ui.em(1.57F)) / 2, choice_width, ui.em(1.57F)};
    if (const auto clicked = segments(ui, choice, options, local.image.disparity ? 1 : 0)) {
        local.image.disparity = *clicked == 1;
    }
    StereoTextures::Parts* parts = textures != nullptr ? &textures->parts() : nullptr;
    if (parts != nullptr) parts->show(shown->picture, {}, ui.theme.too_few);
    const auto which = local.image.disparity ? StereoImage::kDisparity : StereoImage::kLeft;
    CellFrame camera_alone;  // without the registration area
    camera_alone.rig = snapshot.cell.rig;
    (void)draw_stereo_image(ui, {which, picture, "recognise.image"}, *shown->picture, camera_alone,
                            parts, local.image);
    if (!snapshot.cell.rig) return;
    const cv::Mat& left = shown->picture->left;
    const ImageZoom& zoom = which == StereoImage::kLeft ? local.image.first : local.image.second;
    const Overlay overlay{
        ui,
        picture,
        {{static_cast<double>(picture.width), static_cast<double>(picture.height)},
         {static_cast<double>(left.cols), static_cast<double>(left.rows)}},
        zoom,
        *snapshot.cell.rig};
    ImGui::PushClipRect({static_cast<float>(picture.x), static_cast<float>(picture.y)},
                        {static_cast<float>(picture.right()), static_cast<float>(picture.bottom())},
                        true);
    for (std::size_t i = shown->found.size(); i-- > 0;) {
        overlay.box(shown->found[i], ui.theme.*colour_of_found(*shown, i));
        overlay.frame_axes(shown->found[i]);
    }
    // The best find has the first choice of a place.
    std::vector<Rect> taken;
    for (std::size_t i = 0; i < shown->found.size(); ++i) {
        overlay.label(shown->found[i], ui.theme.*colour_of_found(*shown, i), taken);
    }
    ImGui::PopClipRect();
}

void draw_poses(const Ui& ui, const Rect& rect, const Snapshot& snapshot, Requests& out) {
    fill(rect, ui.theme.panel);
    const Rect head{rect.x, rect.y, rect.width, ui.em(kHeader_em)};
    const float x = draw_text(ui, static_cast<float>(head.x) + ui.scale.em(0.86F), middle_of(head),
                              FontRole::kPanelTitle, ui.theme.text, "Poses");
    draw_text(ui, x + ui.scale.em(0.57F), middle_of(head), FontRole::kSmall, ui.theme.text_third,
              "of the template's frame; robot: FANUC world, W P R");
    const auto& shown = snapshot.recognition;
    const bool any = shown && !shown->found.empty();
    const int side = ui.em(2.0F);
    ButtonSpec copy{"recognise.copy", {}, Icon::kCopy};
    copy.tooltip = "Copy the poses in full precision";
    if (!any) copy.why_disabled = "nothing was found yet";
    if (icon_button(
            ui, {head.right() - side - ui.em(0.43F), head.y + (head.height - side) / 2, side, side},
            copy)) {
        out.push_back(request::CopyText{poses_for_clipboard(*shown), "Poses"});
    }
    const Rect body{rect.x, head.bottom(), rect.width, rect.bottom() - head.bottom()};
    if (!any) {
        draw_message(ui, body, "No poses",
                     shown ? "None of the templates was found in this view."
                           : "They stand here once a view was recognised.");
        return;
    }
    (void)draw_text_table(ui, body, "poses", poses_text(*shown), std::nullopt, false);
}

}  // namespace

RecognisePageLayout recognise_page_layout(const Rect& page, const Splits& splits, Scale scale) {
    RecognisePageLayout places;
    const int gap = static_cast<int>(scale.px(4.0F));
    const int column = std::min(page.width / 2, static_cast<int>(scale.px(splits.right_width)));
    const int poses = std::clamp(static_cast<int>(scale.px(splits.bottom_height)), page.height / 5,
                                 page.height / 2);
    const int left = page.width - column - gap;
    const int upper = page.height - poses - gap;
    places.column = {page.right() - column, page.y, column, page.height};
    places.poses = {page.x, page.bottom() - poses, left, poses};
    const bool narrow = left < static_cast<int>(scale.px(640.0F));
    const int image = narrow ? 0 : left * 2 / 5;
    places.image = {page.x, page.y, image, upper};
    places.view = {page.x + (narrow ? 0 : image + gap), page.y, left - (narrow ? 0 : image + gap),
                   upper};
    return places;
}

void draw_recognise_page(const Ui& ui, const RecognisePageLayout& places, const Snapshot& snapshot,
                         StereoTextures* textures, RecognisePageState& local, Requests& out) {
    if (!places.image.empty()) draw_image(ui, places.image, snapshot, textures, local);
    draw_poses(ui, places.poses, snapshot, out);
    draw_recognise_column(ui, places.column, snapshot, local, out);
}

}  // namespace gripscan::ui
