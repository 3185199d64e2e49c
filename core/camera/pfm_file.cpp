#include "core/camera/pfm_file.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"

namespace gripscan {
namespace {

static_assert(std::endian::native == std::endian::little, "PFM is written in the machine's order");

/// The next word of the header; one white-space character ends the last one.
std::string_view next_word(std::string_view text, std::size_t& at) {
    at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    const std::string_view word = text.substr(at, end - at);
    at = end;
    return word;
}

}  // namespace

Status save_pfm(const std::filesystem::path& path, const cv::Mat& image) {
    if (image.type() != CV_32FC1) {
        return input_error("cannot write {}: a PFM file holds one float a pixel", path.string());
    }
    std::string text = fmt::format("Pf\n{} {}\n-1\n", image.cols, image.rows);
    for (int row = image.rows - 1; row >= 0; --row) {
        text.append(reinterpret_cast<const char*>(image.ptr<float>(row)),
                    sizeof(float) * static_cast<std::size_t>(image.cols));
    }
    return write_file_atomically(path, text);
}

Result<cv::Mat> load_pfm(const std::filesystem::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    std::size_t at = 0;
    const auto magic = next_word(*text, at);
    const auto width = number_from_text(next_word(*text, at));
    const auto height = number_from_text(next_word(*text, at));
    const auto scale = number_from_text(next_word(*text, at));
    if (magic != "Pf" || !width || !height || !scale || *width < 1 || *height < 1 ||
        *width > 65536 || *height > 65536 || *scale == 0.0) {
        return input_error("{}: not a PFM file with one channel", path.string());
    }
    const int rows = static_cast<int>(*height);
    const int cols = static_cast<int>(*width);
    const std::size_t row_bytes = sizeof(float) * static_cast<std::size_t>(cols);
    if (text->size() < at + 1 + row_bytes * static_cast<std::size_t>(rows)) {
        return input_error("{}: the file is truncated", path.string());
    }
    cv::Mat image(rows, cols, CV_32FC1);
    const char* bytes = text->data() + at + 1;
    for (int row = rows - 1; row >= 0; --row, bytes += row_bytes) {
        auto* values = image.ptr<float>(row);
        std::memcpy(values, bytes, row_bytes);
        if (*scale > 0.0) {  // big endian
            for (int col = 0; col < cols; ++col) {
                auto* cell = reinterpret_cast<unsigned char*>(values + col);
                std::reverse(cell, cell + sizeof(float));
            }
        }
    }
    return image;
}

}  // namespace gripscan
