#include "ui/panels/stereo_panel.h"

#include <imgui.h>

#include <array>

#include "ui/panels/stereo_images.h"
#include "ui/panels/view3d_overlays.h"
#include "ui/widgets/button.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/legend.h"
#include "ui/widgets/state_shape.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {
namespace {

constexpr float kRow_em = 1.64F;

float middle_y(const Rect& rect) {
    return static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
}

void draw_header(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                 const ShownPicture& shown, StereoPanelState& local, Requests& out) {
    const float y = middle_y(rect);
    const float x = draw_text(ui, static_cast<float>(rect.x) + ui.scale.em(0.86F), y,
                              FontRole::kPanelTitle, ui.theme.text, "Stereo");
    const float title_x = x + ui.scale.em(0.57F);
    const int side = ui.em(2.0F);
    Rect tool{rect.right() - ui.em(0.43F) - side, rect.y + (rect.height - side) / 2, side, side};
    ButtonSpec link{"stereo.link", {}, Icon::kLink};
    link.tooltip = "Zoom and move both images together";
    link.chosen = local.linked;
    if (icon_button(ui, tool, link)) {
        local.linked = !local.linked;
        if (local.linked) local.second = local.first;
    }
    tool.x -= side;
    ButtonSpec live{"stereo.live", {}, snapshot.live.on ? Icon::kPause : Icon::kPlay};
    live.tooltip = snapshot.live.on ? "Hold the live images" : "Show live images";
    live.chosen = shown.live;
    if (!snapshot.session) live.why_disabled = "no session is open";
    if (snapshot.session && snapshot.session->recorded) {
        live.why_disabled = "a recording has no camera";
    }
    if (icon_button(ui, tool, live)) out.emplace_back(request::LiveView{!snapshot.live.on});
    const std::array<Option, 2> options{
        {{"stereo.left_right", "L+R"},
         {"stereo.left_disparity",
          "L+D",
          Icon::kNone,
          {},
          shown.has_disparity ? std::string_view() : "no disparity was computed of these images"}}};
    const Rect choice{tool.x - ui.em(0.43F) - ui.em(7.0F),
                      rect.y + (rect.height - ui.em(1.57F)) / 2, ui.em(7.0F), ui.em(1.57F)};
    draw_text(ui, title_x, y, FontRole::kSmall, ui.theme.text_third,
              fitted(ui, FontRole::kSmall, shown.title,
                     static_cast<float>(choice.x) - title_x - ui.scale.em(0.43F)));
    if (const auto clicked = segments(ui, choice, options, local.disparity ? 1 : 0)) {
        local.disparity = *clicked == 1;
    }
}

State shape_of(FactState state) {
    return state == FactState::kGood      ? State::kAccept
           : state == FactState::kWarning ? State::kCheck
                                          : State::kReject;
}

void draw_fact(const Ui& ui, const Rect& row, const StereoFact& fact) {
    const float y = middle_y(row);
    const auto left = static_cast<float>(row.x) + ui.scale.em(0.86F);
    const auto right = static_cast<float>(row.right()) - ui.scale.em(0.86F);
    const float shape = ui.scale.em(1.43F);
    const float limit = right - shape;
    const float second = limit - ui.scale.em(4.6F);
    const float first = second - ui.scale.em(3.2F);
    draw_text(ui, left, y, FontRole::kTable, ui.theme.text_second, fact.label);
    const bool good = fact.state != FactState::kWarning && fact.state != FactState::kBad;
    const Colour& colour = good ? ui.theme.text : colour_of(ui.theme, shape_of(fact.state));
    draw_text(ui, first, y, FontRole::kNumberTable, colour, fact.left, Align::kRight);
    draw_text(ui, second, y, FontRole::kNumberTable, colour, fact.right, Align::kRight);
    draw_text(ui, limit, y, FontRole::kNumberSmall, ui.theme.text_third, fact.limit, Align::kRight);
    if (fact.state != FactState::kNone) {
        draw_state(ui, right - ui.scale.em(0.5F), y, shape_of(fact.state), 0.93F, ui.theme.panel);
    }
    ImGui::SetCursorScreenPos({static_cast<float>(row.x), static_cast<float>(row.y)});
    ImGui::Dummy({static_cast<float>(row.width), static_cast<float>(row.height)});
    tooltip(ui, {fact.label, fact.left, fact.tooltip});
}

void draw_facts(const Ui& ui, const Rect& rect, const std::vector<StereoFact>& facts) {
    Rect row{rect.x, rect.y, rect.width, ui.em(kRow_em)};
    fill(row, ui.theme.raised);
    const float y = middle_y(row);
    const auto right = static_cast<float>(row.right()) - ui.scale.em(0.86F) - ui.scale.em(1.43F);
    draw_text(ui, static_cast<float>(row.x) + ui.scale.em(0.86F), y, FontRole::kCaption,
              ui.theme.text_third, "in the area");
    draw_text(ui, right, y, FontRole::kCaption, ui.theme.text_third, "limit", Align::kRight);
    draw_text(ui, right - ui.scale.em(4.6F), y, FontRole::kCaption, ui.theme.text_third, "right",
              Align::kRight);
    draw_text(ui, right - ui.scale.em(7.8F), y, FontRole::kCaption, ui.theme.text_third, "left",
              Align::kRight);
    for (const StereoFact& fact : facts) {
        row.y = row.bottom();
        if (row.bottom() > rect.bottom()) break;
        draw_fact(ui, row, fact);
    }
}

void draw_disparity_legend(const Ui& ui, const Rect& image, const DisparityRange& range) {
    const int margin = ui.em(0.57F);
    const int height = ui.em(1.57F);
    const Rect card{image.x + margin, image.bottom() - margin - height, image.width - 2 * margin,
                    height};
    fill(card, ui.theme.plate, ui.scale.em(0.21F));
    const float y = middle_y(card);
    const float left = draw_text(ui, static_cast<float>(card.x) + ui.scale.em(0.57F), y,
                                 FontRole::kNumberCaption, ui.theme.plate_text, range.far_mm);
    const float right = static_cast<float>(card.right()) - ui.scale.em(0.57F);
    draw_text(ui, right, y, FontRole::kNumberCaption, ui.theme.plate_text, range.near_mm,
              Align::kRight);
    const float end = right - text_width(ui, FontRole::kNumberCaption, range.near_mm);
    const int gap = ui.em(0.57F);
    const int bar = ui.em(0.71F);
    draw_map_bar(ui,
                 {static_cast<int>(left) + gap, static_cast<int>(y) - bar / 2,
                  static_cast<int>(end - left) - 2 * gap, bar},
                 ColourMap::kDepth);
}

/// The second image, or what stands in for it.
std::string draw_second(const Ui& ui, const Rect& rect, const ShownPicture& shown,
                        const Snapshot& snapshot, StereoTextures::Parts* textures,
                        StereoPanelState& local) {
    const bool disparity = local.disparity && !shown.picture->disparity.empty();
    const auto row_error_px = pair_facts(snapshot, shown).row_error_px;
    const ImagePlace place =
        disparity
            ? ImagePlace{StereoImage::kDisparity, rect, "stereo.disparity", "Disparity", true}
            : ImagePlace{StereoImage::kRight, rect, "stereo.right", "Right", true, row_error_px};
    std::string pixel =
        draw_stereo_image(ui, place, *shown.picture, snapshot.cell, textures, local);
    if (disparity && textures != nullptr) draw_disparity_legend(ui, rect, textures->range);
    return pixel;
}

void draw_images(const Ui& ui, const Rect& rect, const ShownPicture& shown,
                 const Snapshot& snapshot, StereoTextures::Parts* textures,
                 StereoPanelState& local) {
    const int gap = ui.px(2);
    const Rect first{rect.x, rect.y, rect.width, (rect.height - gap) / 2};
    const Rect second{rect.x, first.bottom() + gap, rect.width, rect.height - gap - first.height};
    if (textures != nullptr) textures->show(shown.picture, snapshot.cell, ui.theme.raised);
    std::string pixel =
        draw_stereo_image(ui, {StereoImage::kLeft, first, "stereo.left", "Left", true},
                          *shown.picture, snapshot.cell, textures, local);
    std::string other = draw_second(ui, second, shown, snapshot, textures, local);
    if (pixel.empty()) pixel = std::move(other);
    if (pixel.empty()) return;
    const float wide = text_width(ui, FontRole::kNumberCaption, pixel) + ui.scale.em(0.86F);
    const Rect plate{rect.right() - static_cast<int>(wide) - ui.em(0.57F), rect.y + ui.em(0.5F),
                     static_cast<int>(wide), ui.em(1.43F)};
    fill(plate, ui.theme.plate, ui.scale.em(0.21F));
    draw_text(ui, static_cast<float>(plate.x) + ui.scale.em(0.43F), middle_y(plate),
              FontRole::kNumberCaption, ui.theme.plate_text, pixel);
}

/// One line below the images: why they are not live.
void draw_reason(const Ui& ui, const Rect& row, const ShownPicture& shown, bool trouble) {
    if (shown.why_not_live.empty()) return;
    const float y = middle_y(row);
    const float x = static_cast<float>(row.x) + ui.scale.em(1.43F);
    if (trouble) {
        draw_state(ui, x, y, State::kReject, 0.93F, ui.theme.panel);
    } else {
        draw_icon(ui, x, y, Icon::kInformation, ui.theme.text_third, FontRole::kIconSmall);
    }
    const float left = x + ui.scale.em(1.0F);
    const std::string words = "not live: " + shown.why_not_live;
    draw_text(ui, left, y, FontRole::kSmall, trouble ? ui.theme.text : ui.theme.text_third,
              fitted(ui, FontRole::kSmall, words,
                     static_cast<float>(row.right()) - left - ui.scale.em(0.57F)));
    ui.log.record({"stereo.why_not_live", words, row, true, {}});
    ImGui::SetCursorScreenPos({static_cast<float>(row.x), static_cast<float>(row.y)});
    ImGui::Dummy({static_cast<float>(row.width), static_cast<float>(row.height)});
    tooltip(ui, {trouble ? "The camera has trouble" : "Not live", {}, shown.why_not_live});
}

/// Heights of the parts of the panel, from its top.
struct Rows {
    Rect header, images, reason, facts;
};
Rows rows_of(const Ui& ui, const Rect& rect, const ShownPicture& shown, std::size_t facts) {
    const int header = ui.em(2.43F);
    const int reason = shown.why_not_live.empty() ? 0 : ui.em(1.71F);
    const int wanted = ui.em(kRow_em) * (static_cast<int>(facts) + 1);
    double aspect = 0.75;
    if (shown.picture && !shown.picture->left.empty()) {
        aspect = static_cast<double>(shown.picture->left.rows) / shown.picture->left.cols;
    }
    const int both = 2 * static_cast<int>(aspect * rect.width) + ui.px(2);
    const int room = rect.height - header - reason - wanted;
    const int least = (rect.height - header - reason) / 3;
    const int images = std::max(least, std::min(both, room));
    const Rect image_rect{rect.x, rect.y + header, rect.width, images};
    const Rect reason_rect{rect.x, image_rect.bottom(), rect.width, reason};
    return {{rect.x, rect.y, rect.width, header},
            image_rect,
            reason_rect,
            {rect.x, reason_rect.bottom(), rect.width, rect.bottom() - reason_rect.bottom()}};
}

}  // namespace

StereoTextures::StereoTextures() = default;
StereoTextures::~StereoTextures() = default;

StereoTextures::Parts& StereoTextures::parts() {
    if (!parts_) parts_ = std::make_unique<Parts>();
    return *parts_;
}

void draw_stereo_panel(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                       StereoTextures* textures, StereoPanelState& local, Requests& out) {
    if (rect.empty()) return;
    fill(rect, ui.theme.panel);
    const ShownPicture shown = shown_picture(snapshot, local.disparity);
    const auto facts = stereo_facts(snapshot, shown);
    const Rows rows = rows_of(ui, rect, shown, facts.size());
    draw_header(ui, rows.header, snapshot, shown, local, out);
    if (shown.picture) {
        draw_images(ui, rows.images, shown, snapshot,
                    textures == nullptr ? nullptr : &textures->parts(), local);
    } else {
        fill(rows.images, ui.theme.bg0);
        draw_message(
            ui, rows.images, "No images yet",
            snapshot.session ? "They come with the camera: connect." : "Begin or open a session.");
    }
    draw_reason(ui, rows.reason, shown, !snapshot.live.trouble.empty());
    draw_facts(ui, rows.facts, facts);
}

}  // namespace gripscan::ui
