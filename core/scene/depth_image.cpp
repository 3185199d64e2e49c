#include "core/scene/depth_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscan {
namespace {

/// Inverse depths of one surface differ by less than this share between neighbours.
constexpr float kOneSurface = 0.04F;

DepthImage empty_image(int width, int height, const Pinhole& camera) {
    const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, camera, std::vector<float>(size, 0.0F), std::vector<float>(size, 0.0F)};
}

/// What a block of pixels has in common.
struct BlockMean {
    float depth_sum = 0.0F;
    float grey_sum = 0.0F;
    float low = 1e9F;
    float high = 0.0F;
    int known = 0;

    void add(float w, float grey) {
        if (w <= 0.0F) return;
        depth_sum += w;
        grey_sum += grey;
        low = std::min(low, w);
        high = std::max(high, w);
        ++known;
    }
    [[nodiscard]] bool one_surface() const { return high - low < kOneSurface * high; }
};

}  // namespace

DepthImage image_of(const EnvironmentModel& model) {
    DepthImage image = empty_image(model.width, model.height, model.camera);
    for (std::size_t i = 0; i < model.pixels.size(); ++i) {
        const EnvironmentPixel& pixel = model.pixels[i];
        // A pixel that sees two surfaces has no depth of its own.
        if (pixel.views == 0 || pixel.far != pixel.near) continue;
        image.inverse_depth_per_m[i] = static_cast<float>(model.inverse_depth_per_m(pixel.mean));
        image.grey[i] = static_cast<float>(pixel.grey);
    }
    return image;
}

DepthImage image_of(const Cloud& cloud, const Pinhole& camera) {
    DepthImage image = empty_image(cloud.grid_width, cloud.grid_height, camera);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (cloud.points[i].z() <= 0.0F) continue;
        const auto cell = static_cast<std::size_t>(cloud.cell[i]);
        image.inverse_depth_per_m[cell] = 1.0F / cloud.points[i].z();
        if (!cloud.intensity.empty()) image.grey[cell] = cloud.intensity[i];
    }
    return image;
}

DepthImage shrunk(const DepthImage& image, int factor, const ForEach& for_each) {
    const double f = factor;
    // Pixel centres are whole numbers, so places scale about the corner (-0.5, -0.5).
    const Pinhole camera{image.camera.fu_px / f, (image.camera.cu_px + 0.5) / f - 0.5,
                         image.camera.fv_px / f, (image.camera.cv_px + 0.5) / f - 0.5};
    DepthImage small = empty_image(image.width / factor, image.height / factor, camera);
    for_each(static_cast<std::size_t>(small.height), [&](std::size_t row) {
        const int v = static_cast<int>(row);
        for (int u = 0; u < small.width; ++u) {
            BlockMean block;
            for (int y = v * factor; y < (v + 1) * factor; ++y) {
                for (int x = u * factor; x < (u + 1) * factor; ++x) {
                    const std::size_t i = image.at(x, y);
                    block.add(image.inverse_depth_per_m[i], image.grey[i]);
                }
            }
            if (2 * block.known < factor * factor || !block.one_surface()) continue;
            const auto n = static_cast<float>(block.known);
            small.inverse_depth_per_m[small.at(u, v)] = block.depth_sum / n;
            small.grey[small.at(u, v)] = block.grey_sum / n;
        }
    });
    return small;
}

std::optional<ImageSample> sample(const DepthImage& image, double u, double v) {
    if (!(u >= 0.0 && v >= 0.0 && u < image.width - 1.0 && v < image.height - 1.0)) {
        return std::nullopt;
    }
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const double a = u - x;
    const double b = v - y;
    const std::array<std::size_t, 4> i = {image.at(x, y), image.at(x + 1, y), image.at(x, y + 1),
                                          image.at(x + 1, y + 1)};
    BlockMean around;
    for (const std::size_t k : i) around.add(image.inverse_depth_per_m[k], 0.0F);
    if (around.known < 4 || !around.one_surface()) return std::nullopt;
    const auto mixed = [&](const std::vector<float>& values, double& value, double& slope_u,
                           double& slope_v) {
        const double p = static_cast<double>(values[i[0]]);
        const double q = static_cast<double>(values[i[1]]);
        const double r = static_cast<double>(values[i[2]]);
        const double s = static_cast<double>(values[i[3]]);
        value = (1 - b) * ((1 - a) * p + a * q) + b * ((1 - a) * r + a * s);
        slope_u = (1 - b) * (q - p) + b * (s - r);
        slope_v = (1 - a) * (r - p) + a * (s - q);
    };
    ImageSample result;
    mixed(image.inverse_depth_per_m, result.inverse_depth, result.inverse_depth_u,
          result.inverse_depth_v);
    mixed(image.grey, result.grey, result.grey_u, result.grey_v);
    return result;
}

}  // namespace gripscan
