#include "core/stereo/depth_cloud.h"

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "core/base/atomic_file.h"

namespace gripscan {
namespace {

Result<cv::Mat> load_depth(const std::filesystem::path& path) {
    const auto bytes = read_whole_file(path);
    if (!bytes) return forward_error(bytes.error());
    const std::vector<unsigned char> buffer(bytes->begin(), bytes->end());
    const cv::Mat image = buffer.empty() ? cv::Mat() : cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
    if (image.empty()) return input_error("{} is not an image that can be read", path.string());
    if (image.type() != CV_16UC1 && image.type() != CV_8UC1) {
        return input_error(
            "{} is no depth image: it has {} channels of {} bytes; one channel of 16 bits is "
            "needed",
            path.string(), image.channels(), image.elemSize1());
    }
    cv::Mat depth;
    image.convertTo(depth, CV_32F);
    return depth;
}

bool makes_sense(const DepthCamera& c) {
    return std::isfinite(c.cx_px) && std::isfinite(c.cy_px) && c.fx_px > 0.0 && c.fy_px > 0.0 &&
           c.depth_scale > 0.0;
}

}  // namespace

Result<Cloud> load_depth_cloud(const std::filesystem::path& path, const DepthCamera& camera) {
    if (!makes_sense(camera)) {
        return input_error("focal lengths and the depth scale must be above 0");
    }
    const auto depth = load_depth(path);
    if (!depth) return forward_error(depth.error());
    Cloud cloud;
    cloud.viewpoint = Eigen::Vector3f::Zero();
    cloud.grid_width = depth->cols;
    cloud.grid_height = depth->rows;
    for (int row = 0; row < depth->rows; ++row) {
        for (int column = 0; column < depth->cols; ++column) {
            const double z_m =
                static_cast<double>(depth->at<float>(row, column)) / camera.depth_scale;
            if (!(z_m > 0.0)) continue;
            cloud.points.push_back(Eigen::Vector3d((column - camera.cx_px) * z_m / camera.fx_px,
                                                   (row - camera.cy_px) * z_m / camera.fy_px, z_m)
                                       .cast<float>());
            cloud.cell.push_back(row * depth->cols + column);
        }
    }
    if (cloud.empty()) return input_error("{} holds no depth: every pixel is 0", path.string());
    return cloud;
}

}  // namespace gripscan
