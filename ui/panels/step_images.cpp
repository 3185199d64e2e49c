#include "ui/panels/step_images.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/views/step_text.h"
#include "ui/widgets/draw.h"

namespace gripscan::ui {
namespace {

const ShownCapture* capture_of(const Snapshot& snapshot, int index) {
    const auto found =
        std::find_if(snapshot.captures.begin(), snapshot.captures.end(),
                     [&](const ShownCapture& capture) { return capture.index == index; });
    return found == snapshot.captures.end() ? nullptr : &*found;
}

/// The largest rectangle of the image's shape in the middle of `room`.
Rect fitted_to(const Rect& room, const cv::Mat& image) {
    const double factor = std::min(static_cast<double>(room.width) / image.cols,
                                   static_cast<double>(room.height) / image.rows);
    const int width = static_cast<int>(factor * image.cols);
    const int height = static_cast<int>(factor * image.rows);
    return {room.x + (room.width - width) / 2, room.y + (room.height - height) / 2, width, height};
}

void draw_label(const Ui& ui, const Rect& image, std::string_view text) {
    const int width = static_cast<int>(text_width(ui, FontRole::kCaption, text)) + ui.em(0.86F);
    const Rect plate{image.x + ui.em(0.36F), image.y + ui.em(0.36F), width, ui.em(1.43F)};
    fill(plate, ui.theme.plate, ui.scale.em(0.21F));
    draw_text(ui, static_cast<float>(plate.x + ui.em(0.43F)),
              static_cast<float>(plate.y) + 0.5F * static_cast<float>(plate.height),
              FontRole::kCaption, ui.theme.plate_text, text);
}

void draw_image(const Ui& ui, const Rect& room, const cv::Mat& image, const std::string& label,
                PictureCache* pictures) {
    if (image.empty()) {
        outline(room, ui.theme.line2, ui.scale.line());
        draw_text(ui, static_cast<float>(room.x) + 0.5F * static_cast<float>(room.width),
                  static_cast<float>(room.y) + 0.5F * static_cast<float>(room.height),
                  FontRole::kSmall, ui.theme.text_third, "no image", Align::kCentre);
        draw_label(ui, room, label);
        return;
    }
    const Rect at = fitted_to(room, image);
    const ImTextureID texture = pictures != nullptr ? pictures->texture(image) : nullptr;
    if (texture != nullptr) {
        ImGui::GetWindowDrawList()->AddImage(
            texture, {static_cast<float>(at.x), static_cast<float>(at.y)},
            {static_cast<float>(at.right()), static_cast<float>(at.bottom())});
    } else {
        fill(at, ui.theme.raised);
    }
    draw_label(ui, at, label);
}

}  // namespace

void draw_step_images(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                      PictureCache* pictures) {
    const auto step = shown_step(snapshot);
    if (!step) {
        draw_text(ui, static_cast<float>(rect.x) + 0.5F * static_cast<float>(rect.width),
                  static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height),
                  FontRole::kTable, ui.theme.text_third,
                  "The images of a step stand here once there is one.", Align::kCentre);
        return;
    }
    const int gap = ui.em(0.57F);
    const Rect area = rect.shrunk(gap);
    for (int i = 0; i < 4; ++i) {
        const int index = i < 2 ? step->row.from : step->row.to;
        const ShownCapture* capture = capture_of(snapshot, index);
        const int from = area.x + (area.width + gap) * i / 4;
        const int to = area.x + (area.width + gap) * (i + 1) / 4 - gap;
        const bool has = capture != nullptr && capture->picture != nullptr;
        const cv::Mat none;
        const cv::Mat& image = !has         ? none
                               : i % 2 == 0 ? capture->picture->left
                                            : capture->picture->right;
        draw_image(ui, {from, area.y, to - from, area.height}, image,
                   fmt::format("Capture {} {}", index, i % 2 == 0 ? "left" : "right"), pictures);
    }
}

}  // namespace gripscan::ui
