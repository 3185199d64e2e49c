// Camera images as textures, uploaded once each.
#pragma once

#include <imgui.h>

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace gripscan::ui {

/// Needs a current OpenGL context. Textures that were not asked for in a frame are let go.
class PictureCache {
  public:
    PictureCache();
    ~PictureCache();
    PictureCache(const PictureCache&) = delete;
    PictureCache& operator=(const PictureCache&) = delete;

    /// An 8-bit grey image; the same data are the same texture. Null for an empty image.
    [[nodiscard]] ImTextureID texture(const cv::Mat& grey);
    /// At the end of a frame.
    void forget_unused();

  private:
    struct Entry;
    std::vector<std::unique_ptr<Entry>> entries_;
};

}  // namespace gripscan::ui
