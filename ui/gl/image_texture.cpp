#include "ui/gl/image_texture.h"

#include "ui/gl/texture_version.h"

namespace gripscan::ui {

void ImageTexture::upload_grey(int width_px, int height_px, const std::uint8_t* pixels,
                               std::size_t row_bytes) {
    upload(width_px, height_px, pixels, row_bytes, 1);
}

void ImageTexture::upload_rgba(int width_px, int height_px, const std::uint8_t* pixels,
                               std::size_t row_bytes) {
    upload(width_px, height_px, pixels, row_bytes, 4);
}

void ImageTexture::upload(int width_px, int height_px, const void* pixels, std::size_t row_bytes,
                          int channels) {
    width_px_ = width_px;
    height_px_ = height_px;
    const bool grey = channels == 1;
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH,
                  static_cast<GLint>(row_bytes / static_cast<std::size_t>(channels)));
    glTexImage2D(GL_TEXTURE_2D, 0, grey ? GL_R8 : GL_RGBA8, width_px, height_px, 0,
                 grey ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const GLint second = grey ? GL_RED : GL_GREEN;
    const GLint third = grey ? GL_RED : GL_BLUE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, second);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, third);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                    magnified_ == Magnified::kSmooth ? GL_LINEAR : GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
    note_texture_changed(texture_.name(), grey ? SeenThrough::kNo : SeenThrough::kYes);
}

}  // namespace gripscan::ui
