#include "core/sim/renderer.h"

#include <utility>

#include "core/base/seeded_random.h"

namespace gripscan::sim {
namespace {

class PixelRays {
  public:
    explicit PixelRays(const Viewpoint& view)
        : view_(view),
          origin_m_(view.T_world_camera.translation().cast<float>()),
          R_world_camera_(view.T_world_camera.linear().cast<float>()) {}

    /// Calls use(ray) for every ray of the pixel; returns their number. Each ray's place on the
    /// lamps is in a grid of cells too, shifted against that within the pixel, so that soft
    /// shadows are stratified.
    template <typename Use>
    int for_each_ray(int column, int row, const Use& use) const {
        const bool dense = view_.dense.contains({column, row});
        const int side = dense ? 3 : 2;
        const int cells = side * side;
        SeededRandom random(view_.jitter_seed + (static_cast<std::uint64_t>(row) << 32U |
                                                 static_cast<unsigned>(column)));
        const int lamp_shift = static_cast<int>(random.next() % static_cast<unsigned>(cells));
        // Cells of 2 × 2: 0 and 3, or 1 and 2, are opposite.
        const int first = dense ? 0 : static_cast<int>(random.next() % 2U);
        const int step = dense ? 1 : cells - 1 - 2 * first;
        int rays = 0;
        for (int i = first; i < cells - first; i += step) {
            const Eigen::Vector2f in_pixel = in_cell(i, side, random);
            const Eigen::Vector2f on_lamp = in_cell((i + lamp_shift) % cells, side, random);
            const Eigen::Vector2f x =
                view_.lens->direction_at(static_cast<float>(column) - 0.5F + in_pixel.x(),
                                         static_cast<float>(row) - 0.5F + in_pixel.y());
            const Eigen::Vector3f direction =
                (R_world_camera_ * Eigen::Vector3f(x.x(), x.y(), 1.0F)).normalized();
            use(ViewRay{origin_m_, direction, 2.0F * on_lamp - Eigen::Vector2f::Ones()});
            ++rays;
        }
        return rays;
    }

  private:
    static Eigen::Vector2f in_cell(int i, int side, SeededRandom& random) {
        const auto x = static_cast<float>(random.uniform());
        const auto y = static_cast<float>(random.uniform());
        return Eigen::Vector2f(static_cast<float>(i % side) + x, static_cast<float>(i / side) + y) /
               static_cast<float>(side);
    }

    const Viewpoint& view_;
    Eigen::Vector3f origin_m_;
    Eigen::Matrix3f R_world_camera_;
};

struct Pixel {
    float brightness = 0.0F;
    bool live = false;
};

Pixel whole_pixel(const Shader& shader, const PixelRays& rays, int column, int row) {
    Pixel pixel;
    const int count = rays.for_each_ray(column, row, [&](const ViewRay& ray) {
        const auto end = shader.trace(ray);
        pixel.brightness += shader.brightness(ray, end);
        pixel.live = pixel.live || shader.depends_on_joint6(ray, end);
    });
    pixel.brightness /= static_cast<float>(count);
    return pixel;
}

float live_pixel(const Shader& shader, const PixelRays& rays, int column, int row) {
    float sum = 0.0F;
    const int count = rays.for_each_ray(
        column, row, [&](const ViewRay& ray) { sum += shader.brightness(ray, shader.trace(ray)); });
    return sum / static_cast<float>(count);
}

}  // namespace

Picture render_all(const Shader& shader, const Viewpoint& view, const ForEach& for_each) {
    const ImageSize size = view.lens->image();
    Picture picture{cv::Mat(size.height, size.width, CV_32F),
                    cv::Mat(size.height, size.width, CV_8U)};
    const PixelRays rays(view);
    for_each(static_cast<std::size_t>(size.height), [&](std::size_t index) {
        const int row = static_cast<int>(index);
        for (int column = 0; column < size.width; ++column) {
            const Pixel pixel = whole_pixel(shader, rays, column, row);
            picture.brightness.at<float>(row, column) = pixel.brightness;
            picture.live.at<std::uint8_t>(row, column) = pixel.live ? 255 : 0;
        }
    });
    return picture;
}

void render_live(const Shader& shader, const Viewpoint& view, Picture& picture,
                 const ForEach& for_each) {
    const PixelRays rays(view);
    for_each(static_cast<std::size_t>(picture.live.rows), [&](std::size_t index) {
        const int row = static_cast<int>(index);
        for (int column = 0; column < picture.live.cols; ++column) {
            if (picture.live.at<std::uint8_t>(row, column) == 0) continue;
            picture.brightness.at<float>(row, column) = live_pixel(shader, rays, column, row);
        }
    });
}

}  // namespace gripscan::sim
