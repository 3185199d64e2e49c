#include "ui/shell/partial_painter.h"

#include <string_view>

#include "ui/gl/texture_version.h"

namespace gripscan::ui {
namespace {

GLuint name_of(ImTextureID id) {
    return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(id));
}

std::uint64_t version_of(ImTextureID id) {
    return texture_version(name_of(id));
}

bool opaque(ImTextureID id) {
    return texture_opaque(name_of(id));
}

bool software_rasteriser() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view renderer = name != nullptr ? name : "";
    return renderer.starts_with("llvmpipe") || renderer.starts_with("softpipe");
}

}  // namespace

PartialPainter::PartialPainter(std::unique_ptr<ImGuiPainter> painter)
    : painter_(std::move(painter)),
      damage_(version_of, opaque),
      window_keeps_(software_rasteriser()) {}

void PartialPainter::begin_frame(bool fonts_changed) {
    painter_->begin_frame(fonts_changed);
    if (fonts_changed) damage_.forget();
}

Result<bool> PartialPainter::paint(int width_px, int height_px) {
    const bool fits = window_keeps_ || (picture_ && picture_->width_px() == width_px &&
                                        picture_->height_px() == height_px);
    if (!fits) {
        auto made = RenderTarget::make(width_px, height_px, DepthTexture::kNone);
        if (!made) return forward_error(made.error());
        picture_.emplace(*std::move(made));
        damage_.forget();
    }
    const ImDrawData& frame = *ImGui::GetDrawData();
    const std::vector<Piece> pieces = damage_.next(frame);
    if (picture_) {
        picture_->bind();
    } else {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, width_px, height_px);
    }
    for (const Piece& piece : pieces) {
        const ClippedFrame clipped(frame, piece.rect, piece.first_command);
        painter_->paint();
    }
    return !pieces.empty();
}

void PartialPainter::show() const {
    if (picture_) picture_->copy_to_window();
}

}  // namespace gripscan::ui
