#include "core/sim/renderer.h"

#include <cmath>

#include "core/base/seeded_random.h"

namespace gripscan::sim {
namespace {

class PixelRenderer {
  public:
    PixelRenderer(const Shader& shader, const Viewpoint& view)
        : shader_(shader),
          view_(view),
          origin_m_(view.T_world_camera.translation().cast<float>()),
          R_world_camera_(view.T_world_camera.linear().cast<float>()) {}

    /// Mean of rays_per_side² rays, each somewhere in its own cell of the pixel; the places on the
    /// lamps are those of the next cell but some, so that soft shadows are stratified too.
    float pixel(int column, int row, int rays_per_side) const {
        SeededRandom random(view_.jitter_seed + (static_cast<std::uint64_t>(row) << 32U |
                                                 static_cast<unsigned>(column)));
        const int rays = rays_per_side * rays_per_side;
        const float cell = 1.0F / static_cast<float>(rays_per_side);
        const int lamp_shift = static_cast<int>(random.next() % static_cast<unsigned>(rays));
        float sum = 0.0F;
        for (int i = 0; i < rays; ++i) {
            const auto [u, v] = in_cell(i, rays_per_side, cell, random);
            const auto [s, t] = in_cell((i + lamp_shift) % rays, rays_per_side, cell, random);
            sum += ray(static_cast<float>(column) - 0.5F + u, static_cast<float>(row) - 0.5F + v,
                       {2.0F * s - 1.0F, 2.0F * t - 1.0F});
        }
        return sum / static_cast<float>(rays);
    }

  private:
    static std::pair<float, float> in_cell(int i, int side, float cell, SeededRandom& random) {
        const auto x = static_cast<float>(random.uniform());
        const auto y = static_cast<float>(random.uniform());
        return {(static_cast<float>(i % side) + x) * cell,
                (static_cast<float>(i / side) + y) * cell};
    }

    float ray(float u_px, float v_px, const LampSample& at) const {
        const Eigen::Vector2f x = view_.lens->direction_at(u_px, v_px);
        const Eigen::Vector3f direction =
            (R_world_camera_ * Eigen::Vector3f(x.x(), x.y(), 1.0F)).normalized();
        return shader_.brightness(origin_m_, direction, at);
    }

    const Shader& shader_;
    const Viewpoint& view_;
    Eigen::Vector3f origin_m_;
    Eigen::Matrix3f R_world_camera_;
};

}  // namespace

cv::Mat render(const Shader& shader, const Viewpoint& view, const Sampling& sampling,
               const ForEach& for_each) {
    const ImageSize size = view.lens->image();
    cv::Mat image(size.height, size.width, CV_32F);
    const PixelRenderer renderer(shader, view);
    const int side_dense = static_cast<int>(std::lround(std::sqrt(sampling.rays_dense)));
    const int side_else = static_cast<int>(std::lround(std::sqrt(sampling.rays_else)));
    for_each(static_cast<std::size_t>(size.height), [&](std::size_t index) {
        const int row = static_cast<int>(index);
        auto* out = image.ptr<float>(row);
        for (int column = 0; column < size.width; ++column) {
            const bool dense = sampling.dense.contains({column, row});
            out[column] = renderer.pixel(column, row, dense ? side_dense : side_else);
        }
    });
    return image;
}

}  // namespace gripscan::sim
