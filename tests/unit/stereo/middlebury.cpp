#include "tests/unit/stereo/middlebury.h"

#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>

namespace gripscan::test {
namespace fs = std::filesystem;
namespace {

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Number after "key=", for the matrices the n-th one after it.
double number(const std::string& text, const std::string& key, int n = 0) {
    const std::size_t at = text.find(key + "=");
    if (at == std::string::npos) throw std::runtime_error("no " + key + " in calib.txt");
    std::string rest = text.substr(at + key.size() + 1);
    for (char& c : rest) {
        if (c == '[' || c == ']' || c == ';') c = ' ';
    }
    std::istringstream words(rest);
    double value = 0.0;
    for (int i = 0; i <= n; ++i) words >> value;
    return value;
}

/// PFM: raw floats, rows bottom-up. cv::imread would scale them.
cv::Mat1f read_pfm(const fs::path& path) {
    std::istringstream file(text_of(path));
    std::string magic;
    int width = 0, height = 0;
    double scale = 0.0;
    file >> magic >> width >> height >> scale;
    if (magic != "Pf" || !(scale < 0.0)) throw std::runtime_error("no PFM: " + path.string());
    file.get();
    cv::Mat1f image(height, width);
    for (int y = height - 1; y >= 0; --y) {
        file.read(reinterpret_cast<char*>(image.ptr<float>(y)), width * 4);
    }
    if (!file) throw std::runtime_error("cut short: " + path.string());
    return image;
}

}  // namespace

MiddleburyScene read_middlebury(const fs::path& folder) {
    const std::string calib = text_of(folder / "calib.txt");
    MiddleburyScene scene;
    scene.frame.left = cv::imread((folder / "im0.png").string(), cv::IMREAD_GRAYSCALE);
    scene.frame.right = cv::imread((folder / "im1.png").string(), cv::IMREAD_GRAYSCALE);
    scene.rig.image = {scene.frame.left.cols, scene.frame.left.rows};
    scene.rig.f_px = number(calib, "cam0", 0);
    scene.rig.cx_left_px = number(calib, "cam0", 2);
    scene.rig.cx_right_px = number(calib, "cam1", 2);
    scene.rig.cy_px = number(calib, "cam0", 5);
    scene.rig.baseline_m = number(calib, "baseline") / 1000.0;
    scene.disparities = 16 * ((static_cast<int>(number(calib, "ndisp")) + 15) / 16);
    scene.truth = read_pfm(folder / "disp0GT.pfm");
    return scene;
}

}  // namespace gripscan::test
