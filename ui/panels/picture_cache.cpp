#include "ui/panels/picture_cache.h"

#include <algorithm>

#include "ui/gl/image_texture.h"
#include "ui/imgui_compat.h"

namespace gripscan::ui {

namespace {
constexpr std::size_t kMost = 8;  ///< two captures, left and right, and as many of the step before
}

/// The image is kept so that its data stay where they are, and no other can have their address.
struct PictureCache::Entry {
    cv::Mat image;
    ImageTexture texture{Magnified::kSmooth};
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
        entries_.push_back(std::make_unique<Entry>());
        Entry& entry = *entries_.back();
        entry.image = grey;
        entry.texture.upload_grey(grey.cols, grey.rows, grey.data, grey.step);
    }
    return imgui_texture(entries_.back()->texture.name());
}

}  // namespace gripscan::ui
