#include "app/workstation/picture_file.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/atomic_file.h"

namespace gripscan::app {

Status save_png(const std::filesystem::path& file, int width_px, int height_px,
                std::span<const std::uint8_t> rgba) {
    const auto expected = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
    if (rgba.size() != 4 * expected) {
        return input_error("{}: the picture is not {} x {} px", file.string(), width_px, height_px);
    }
    const cv::Mat colours(height_px, width_px, CV_8UC4, const_cast<std::uint8_t*>(rgba.data()));
    cv::Mat bgr;
    cv::cvtColor(colours, bgr, cv::COLOR_RGBA2BGR);
    std::vector<std::uint8_t> png;
    if (!cv::imencode(".png", bgr, png)) {
        return input_error("{}: the picture could not be made", file.string());
    }
    return write_file_atomically(
        file, std::string_view(reinterpret_cast<const char*>(png.data()), png.size()));
}

}  // namespace gripscan::app
