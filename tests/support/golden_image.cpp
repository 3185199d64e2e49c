#include "tests/support/golden_image.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace gripscan::test {
namespace {

namespace fs = std::filesystem;

void write_png(const fs::path& path, const Picture& picture) {
    cv::Mat rgba(picture.height, picture.width, CV_8UC4,
                 const_cast<std::uint8_t*>(picture.rgba.data()));  // read only
    cv::Mat bgr;
    cv::cvtColor(rgba, bgr, cv::COLOR_RGBA2BGR);
    fs::create_directories(path.parent_path());
    cv::imwrite(path.string(), bgr, {cv::IMWRITE_PNG_COMPRESSION, 9});
}

Picture read_png(const fs::path& path) {
    const cv::Mat bgr = cv::imread(path.string(), cv::IMREAD_COLOR);
    if (bgr.empty()) return {};
    cv::Mat rgba;
    cv::cvtColor(bgr, rgba, cv::COLOR_BGR2RGBA);
    return {rgba.cols, rgba.rows, {rgba.datastart, rgba.dataend}};
}

bool differs(const Picture& a, const Picture& b, std::size_t pixel) {
    for (std::size_t c = 0; c < 3; ++c) {
        const int step = std::abs(static_cast<int>(a.rgba[4 * pixel + c]) - b.rgba[4 * pixel + c]);
        if (step >= ImageTolerance::kChannel) return true;
    }
    return false;
}

/// Where the pictures differ in red, the rest in faint grey.
Picture difference(const Picture& actual, const Picture& expected) {
    Picture result = actual;
    const bool same_size = actual.rgba.size() == expected.rgba.size();
    for (std::size_t i = 0; i < actual.rgba.size() / 4; ++i) {
        std::uint8_t* p = &result.rgba[4 * i];
        if (!same_size || differs(actual, expected, i)) {
            p[0] = 255;
            p[1] = p[2] = 0;
        } else {
            p[0] = p[1] = p[2] = static_cast<std::uint8_t>(p[1] / 3);
        }
    }
    return result;
}

}  // namespace

std::size_t different_pixels(const Picture& one, const Picture& other) {
    const std::size_t pixels = one.rgba.size() / 4;
    if (one.width != other.width || one.height != other.height) return pixels;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels; ++i) count += differs(one, other, i) ? 1 : 0;
    return count;
}

void expect_golden(const Picture& picture, const std::string& name) {
    const fs::path golden =
        fs::path(GRIPSCAN_SOURCE_DIR) / "tests" / "render" / "golden" / (name + ".png");
    if (const char* update = std::getenv("GRIPSCAN_UPDATE_GOLDEN"); update && *update == '1') {
        write_png(golden, picture);
        GTEST_SKIP() << "wrote " << golden << ": look at it";
    }
    const Picture expected = read_png(golden);
    ASSERT_FALSE(expected.rgba.empty())
        << golden << " is missing; GRIPSCAN_UPDATE_GOLDEN=1 writes it";
    const std::size_t count = different_pixels(picture, expected);
    const auto allowed = static_cast<std::size_t>(
        ImageTolerance::kShare * static_cast<double>(picture.width) * picture.height);
    if (count <= allowed) return;
    const fs::path folder = fs::temp_directory_path() / "gripscan-golden";
    write_png(folder / (name + ".actual.png"), picture);
    write_png(folder / (name + ".expected.png"), expected);
    write_png(folder / (name + ".difference.png"), difference(picture, expected));
    ADD_FAILURE() << name << ": " << count << " pixels differ, " << allowed << " may; see "
                  << folder / (name + ".difference.png");
}

}  // namespace gripscan::test
