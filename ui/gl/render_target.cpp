#include "ui/gl/render_target.h"

#include <algorithm>

namespace gripscan::ui {
namespace {

void allocate(const GlTexture& texture, GLint internal, GLenum format, GLenum type, int width,
              int height, GLint filter) {
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

Result<RenderTarget> RenderTarget::make(int width_px, int height_px, DepthTexture depth) {
    constexpr int kLargest = 16384;
    if (width_px < 1 || height_px < 1 || width_px > kLargest || height_px > kLargest) {
        return input_error("a picture of {} x {} px cannot be drawn; sides go from 1 to {} px",
                           width_px, height_px, kLargest);
    }
    RenderTarget target(width_px, height_px);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer_.name());
    allocate(target.colour_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width_px, height_px, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           target.colour_.name(), 0);
    if (depth == DepthTexture::kFloat32) {
        target.depth_.emplace();
        allocate(*target.depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width_px,
                 height_px, GL_NEAREST);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                               target.depth_->name(), 0);
    }
    const GLenum state = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (state != GL_FRAMEBUFFER_COMPLETE) {
        return device_error("the graphics driver refuses a picture of {} x {} px (status {:#x})",
                            width_px, height_px, state);
    }
    return target;
}

void RenderTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width_px_, height_px_);
}

void RenderTarget::stretch_smoothly() const {
    glBindTexture(GL_TEXTURE_2D, colour_.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void RenderTarget::copy_to_window() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width_px_, height_px_, 0, 0, width_px_, height_px_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<std::uint8_t> RenderTarget::read_rgba() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    return read_framebuffer_rgba(width_px_, height_px_);
}

std::vector<float> RenderTarget::read_depth(int x, int y, int width, int height) const {
    std::vector<float> depths(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                              1.0F);
    if (!depth_) return depths;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(x, y, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    return depths;
}

std::vector<std::uint8_t> read_framebuffer_rgba(int width_px, int height_px) {
    const auto stride = static_cast<std::size_t>(width_px) * 4;
    std::vector<std::uint8_t> pixels(stride * static_cast<std::size_t>(height_px));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_px, height_px, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::size_t top = 0, bottom = static_cast<std::size_t>(height_px) - 1; top < bottom;
         ++top, --bottom) {
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(top * stride),
                         pixels.begin() + static_cast<std::ptrdiff_t>((top + 1) * stride),
                         pixels.begin() + static_cast<std::ptrdiff_t>(bottom * stride));
    }
    return pixels;
}

}  // namespace gripscan::ui
