// Camera images as textures, uploaded once each.
#pragma once

#include <imgui.h>

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace gripscan::ui {

/// Needs a current OpenGL context from the first image to its end. Only the latest images asked for
/// are kept: as many as are shown at once.
class PictureCache {
  public:
    PictureCache();
    ~PictureCache();
    PictureCache(const PictureCache&) = delete;
    PictureCache& operator=(const PictureCache&) = delete;

    /// An 8-bit grey image; the same data are the same texture. Null for any other image.
    [[nodiscard]] ImTextureID texture(const cv::Mat& grey);

  private:
    struct Entry;
    std::vector<std::unique_ptr<Entry>> entries_;  ///< the latest last
};

}  // namespace gripscan::ui
