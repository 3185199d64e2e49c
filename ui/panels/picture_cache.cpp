#include "ui/panels/picture_cache.h"

#include <algorithm>

#include "ui/gl/grey_texture.h"
#include "ui/imgui_compat.h"

namespace gripscan::ui {

namespace {
constexpr std::size_t kMost = 8;  ///< two captures, left and right, and as many of the step before
}

/// The image is kept so that its data stay where they are, and no other can have their address.
struct PictureCache::Entry {
    cv::Mat image;
    GreyTexture texture;
};

PictureCache::PictureCache() = default;
PictureCache::~PictureCache() = default;

ImTextureID PictureCache::texture(const cv::Mat& grey) {
    if (grey.empty() || grey.type() != CV_8UC1) return nullptr;
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) {
        return entry->image.data == grey.data && entry->image.size() == grey.size();
    });
    if (found != entries_.end()) {
        std::rotate(found, found + 1, entries_.end());
    } else {
        if (entries_.size() >= kMost) entries_.erase(entries_.begin());
        entries_.push_back(std::unique_ptr<Entry>(
            new Entry{grey, GreyTexture(grey.data, grey.cols, grey.rows, grey.step)}));
    }
    return imgui_texture(entries_.back()->texture.name());
}

}  // namespace gripscan::ui
