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

    /// Calls use(ray) for every ray of the pixel. Each ray's place on the lamps is in a grid of
    /// cells too, shifted against that within the pixel, so that soft shadows are stratified.
    /// Returns the number of rays.
    template <typename Use>
    int for_each_ray(int column, int row, const Use& use) const {
        const int side = view_.dense.contains({column, row}) ? view_.grid_dense : view_.grid_else;
        const int rays = side * side;
        SeededRandom random(view_.jitter_seed + (static_cast<std::uint64_t>(row) << 32U |
                                                 static_cast<unsigned>(column)));
        const int lamp_shift = static_cast<int>(random.next() % static_cast<unsigned>(rays));
        for (int i = 0; i < rays; ++i) {
            const Eigen::Vector2f in_pixel = in_cell(i, side, random);
            const Eigen::Vector2f on_lamp = in_cell((i + lamp_shift) % rays, side, random);
            const Eigen::Vector2f x =
                view_.lens->direction_at(static_cast<float>(column) - 0.5F + in_pixel.x(),
                                         static_cast<float>(row) - 0.5F + in_pixel.y());
            const Eigen::Vector3f direction =
                (R_world_camera_ * Eigen::Vector3f(x.x(), x.y(), 1.0F)).normalized();
            use(ViewRay{origin_m_, direction, 2.0F * on_lamp - Eigen::Vector2f::Ones()});
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

float pixel_brightness(const Shader& shader, const PixelRays& rays, int column, int row) {
    float sum = 0.0F;
    const int count =
        rays.for_each_ray(column, row, [&](const ViewRay& ray) { sum += shader.brightness(ray); });
    return sum / static_cast<float>(count);
}

bool pixel_is_live(const Shader& shader, const PixelRays& rays, int column, int row) {
    bool live = false;
    rays.for_each_ray(column, row,
                      [&](const ViewRay& ray) { live = live || shader.depends_on_joint6(ray); });
    return live;
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
            picture.brightness.at<float>(row, column) = pixel_brightness(shader, rays, column, row);
            picture.live.at<std::uint8_t>(row, column) =
                pixel_is_live(shader, rays, column, row) ? 255 : 0;
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
            picture.brightness.at<float>(row, column) = pixel_brightness(shader, rays, column, row);
        }
    });
}

}  // namespace gripscan::sim
