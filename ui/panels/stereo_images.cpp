#include "ui/panels/stereo_images.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/imgui_compat.h"
#include "ui/theme/colour_map.h"
#include "ui/theme/on_plate.h"
#include "ui/widgets/draw.h"

namespace gripscan::ui {
namespace {

const cv::Mat& image_of(const StereoPicture& picture, StereoImage which) {
    return which == StereoImage::kLeft    ? picture.left
           : which == StereoImage::kRight ? picture.right
                                          : picture.disparity;
}

std::vector<std::uint8_t> coloured(const cv::Mat& disparity, const DisparityRange& range,
                                   const Colour& unknown) {
    const auto colours = map_bytes(ColourMap::kDepth);
    const double span = range.near_px - range.far_px;
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * disparity.total());
    for (int y = 0; y < disparity.rows; ++y) {
        const auto* row = disparity.ptr<float>(y);
        for (int x = 0; x < disparity.cols; ++x) {
            if (!std::isfinite(row[x])) {
                rgba.insert(rgba.end(), {unknown.r, unknown.g, unknown.b, 255});
                continue;
            }
            const double t = std::clamp((row[x] - range.far_px) / span, 0.0, 1.0);
            const auto* colour = colours.data() + 4 * static_cast<std::size_t>(t * 255.0 + 0.5);
            rgba.insert(rgba.end(), colour, colour + 4);
        }
    }
    return rgba;
}

/// A solid plate behind words: images are bright in both themes.
void draw_plate(const Ui& ui, float x, float y, std::string_view text, Align align,
                const Colour& colour, FontRole role) {
    const float wide = text_width(ui, role, text);
    const float pad = ui.scale.em(0.43F);
    const float left = align == Align::kRight ? x - wide - 2.0F * pad : x;
    const int height = ui.em(1.43F);
    fill({static_cast<int>(left), static_cast<int>(y) - height / 2,
          static_cast<int>(wide + 2.0F * pad), height},
         ui.theme.plate, ui.scale.em(0.21F));
    draw_text(ui, left + pad, y, role, colour, text);
}

ImVec2 on_screen(const Rect& rect, const Eigen::Vector2d& in_frame) {
    return {static_cast<float>(rect.x + in_frame.x()), static_cast<float>(rect.y + in_frame.y())};
}

void draw_area(const Ui& ui, const ImagePlace& place, const ImageFrame& frame,
               const ImageZoom& zoom, const CellFrame& cell) {
    const Eye eye = place.which == StereoImage::kRight ? Eye::kRight : Eye::kLeft;
    const auto outline_px = area_outline_px(cell, eye);
    for (std::size_t i = 0; i < outline_px.size(); ++i) {
        const auto& a = outline_px[i];
        const auto& b = outline_px[(i + 1) % outline_px.size()];
        draw_line(ui, on_screen(place.rect, frame.to_frame(zoom, a)),
                  on_screen(place.rect, frame.to_frame(zoom, b)), ui.theme.accent,
                  ui.scale.px(1.6F));
    }
}

/// A row through the image; beside the right one stands which, and how far the rows are apart.
void draw_ruler(const Ui& ui, const ImagePlace& place, const ImageFrame& frame,
                const ImageZoom& zoom, double ruler) {
    const double row = ruler * frame.image_px.y();
    const ImVec2 at = on_screen(place.rect, frame.to_frame(zoom, {0.0, row}));
    if (at.y > static_cast<float>(place.rect.y) && at.y < static_cast<float>(place.rect.bottom())) {
        draw_line(ui, {static_cast<float>(place.rect.x), at.y},
                  {static_cast<float>(place.rect.right()), at.y}, ui.theme.axis);
    }
    if (place.which != StereoImage::kRight) return;
    const int whole = static_cast<int>(row);
    const auto below = on_screen(place.rect, frame.to_frame(zoom, {0.0, whole + 0.5}));
    draw_plate(ui, static_cast<float>(place.rect.right()) - ui.scale.em(0.57F),
               std::min(below.y + ui.scale.em(1.0F),
                        static_cast<float>(place.rect.bottom()) - ui.scale.em(1.0F)),
               row_text(whole, place.row_error_px), Align::kRight,
               on_plate(ui.theme, ui.theme.axis), FontRole::kNumberCaption);
}

struct ImageMouse {
    bool hovered = false;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< in the frame
};

ImageMouse take_mouse(const Ui& ui, const ImagePlace& place, const ImageFrame& frame,
                      ImageZoom& zoom) {
    ui.log.record({std::string(place.id), std::string(place.name), place.rect, true, {}});
    ImGui::SetCursorScreenPos({static_cast<float>(place.rect.x), static_cast<float>(place.rect.y)});
    ImGui::PushAllowKeyboardFocus(false);
    ImGui::InvisibleButton(
        std::string(place.id).c_str(),
        {static_cast<float>(place.rect.width), static_cast<float>(place.rect.height)},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
            ImGuiButtonFlags_MouseButtonMiddle);
    ImGui::PopAllowKeyboardFocus();
    ImGui::SetItemAllowOverlap();
    const ImGuiIO& io = ImGui::GetIO();
    ImageMouse mouse{ImGui::IsItemHovered(),
                     {io.MousePos.x - static_cast<float>(place.rect.x),
                      io.MousePos.y - static_cast<float>(place.rect.y)}};
    if (mouse.hovered && io.MouseWheel != 0.0F) {
        zoom = zoomed_at(zoom, static_cast<double>(io.MouseWheel), mouse.at, frame);
    }
    if (ImGui::IsItemActive()) {
        zoom = moved_by(zoom, {io.MouseDelta.x, io.MouseDelta.y}, frame);
    }
    if (mouse.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) zoom = {};
    return mouse;
}

void draw_pixels(const Ui& ui, const ImagePlace& place, const ImageFrame& frame,
                 const ImageZoom& zoom, StereoTextures::Parts* textures) {
    fill(place.rect, ui.theme.bg0);
    if (textures == nullptr) return;
    const ImageTexture& texture = place.which == StereoImage::kLeft    ? textures->left
                                  : place.which == StereoImage::kRight ? textures->right
                                                                       : textures->disparity;
    if (texture.name() == 0) return;
    ImGui::GetWindowDrawList()->AddImage(
        imgui_texture(texture.name()),
        on_screen(place.rect, frame.to_frame(zoom, Eigen::Vector2d::Zero())),
        on_screen(place.rect, frame.to_frame(zoom, frame.image_px)));
}

}  // namespace

void StereoTextures::Parts::show(const std::shared_ptr<const StereoPicture>& picture,
                                 const CellFrame& cell, const Colour& unknown) {
    if (uploaded == picture || !picture) return;
    uploaded = picture;
    range = disparity_range(*picture, cell);
    left.upload_grey(picture->left.cols, picture->left.rows, picture->left.data,
                     picture->left.step[0]);
    right.upload_grey(picture->right.cols, picture->right.rows, picture->right.data,
                      picture->right.step[0]);
    if (picture->disparity.empty()) return;
    const auto rgba = coloured(picture->disparity, range, unknown);
    disparity.upload_rgba(picture->disparity.cols, picture->disparity.rows, rgba.data(),
                          4 * static_cast<std::size_t>(picture->disparity.cols));
}

std::string draw_stereo_image(const Ui& ui, const ImagePlace& place, const StereoPicture& picture,
                              const CellFrame& cell, StereoTextures::Parts* textures,
                              StereoPanelState& local) {
    const cv::Mat& image = image_of(picture, place.which);
    if (image.empty() || place.rect.empty()) return {};
    const ImageFrame frame{
        {static_cast<double>(place.rect.width), static_cast<double>(place.rect.height)},
        {static_cast<double>(image.cols), static_cast<double>(image.rows)}};
    ImageZoom& zoom = place.which == StereoImage::kLeft ? local.first : local.second;
    const ImageMouse mouse = take_mouse(ui, place, frame, zoom);
    if (local.linked) (place.which == StereoImage::kLeft ? local.second : local.first) = zoom;
    ImGui::PushClipRect(
        {static_cast<float>(place.rect.x), static_cast<float>(place.rect.y)},
        {static_cast<float>(place.rect.right()), static_cast<float>(place.rect.bottom())}, true);
    draw_pixels(ui, place, frame, zoom, textures);
    draw_area(ui, place, frame, zoom, cell);
    const Eigen::Vector2d pixel = frame.to_image(zoom, mouse.at);
    if (mouse.hovered) local.ruler = std::clamp(pixel.y() / frame.image_px.y(), 0.0, 1.0);
    if (place.ruler) draw_ruler(ui, place, frame, zoom, local.ruler);
    if (!place.name.empty()) {
        draw_plate(ui, static_cast<float>(place.rect.x) + ui.scale.em(0.57F),
                   static_cast<float>(place.rect.y) + ui.scale.em(1.21F), place.name, Align::kLeft,
                   ui.theme.plate_text, FontRole::kSmall);
    }
    ImGui::PopClipRect();
    if (!mouse.hovered) return {};
    const auto x = static_cast<int>(std::floor(pixel.x()));
    const auto y = static_cast<int>(std::floor(pixel.y()));
    return place.which == StereoImage::kDisparity ? disparity_text(picture, cell, x, y)
                                                  : level_text(image, x, y);
}

}  // namespace gripscan::ui
