#include "core/scene/environment_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/cloud/blocks.h"

namespace gripscan {
namespace {

/// Inverse depths around a pixel that are the environment's, their deviation included.
struct DepthRange {
    double far = std::numeric_limits<double>::infinity();
    double near = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool known() const { return near >= far; }
    void include(double from, double to) {
        far = std::min(far, from);
        near = std::max(near, to);
    }
};

/// Standard deviation of the difference between a point and what is known of its pixel.
double deviation(const EnvironmentModel& model, int u, int v, double point_sigma) {
    const EnvironmentPixel pixel = model.at(u, v);
    if (pixel.views == 0) return std::numbers::sqrt2 * std::max(point_sigma, model.noise_per_m);
    return std::max(point_sigma, model.sigma_per_m(pixel)) * std::sqrt(1.0 + 1.0 / pixel.views);
}

DepthRange range_at(const EnvironmentModel& model, int u, int v, double point_sigma,
                    const SubtractSettings& settings) {
    DepthRange range;
    const int r = settings.edge_px;
    const double slack = settings.sigmas * deviation(model, u, v, point_sigma);
    for (int y = v - r; y <= v + r; ++y) {
        for (int x = u - r; x <= u + r; ++x) {
            const EnvironmentPixel pixel = model.at(x, y);
            if (pixel.views == 0) continue;
            range.include(model.inverse_depth_per_m(pixel.far) - slack,
                          model.inverse_depth_per_m(pixel.near) + slack);
        }
    }
    return range;
}

ScenePoint kind_of(const EnvironmentModel& model, const Eigen::Vector3d& p, double point_sigma,
                   const SubtractSettings& settings) {
    if (p.z() <= 0.0) return ScenePoint::kUnknown;
    const Eigen::Vector2d seen = model.camera.project(p);
    const int u = static_cast<int>(std::lround(std::clamp(seen.x(), -1e6, 1e6)));
    const int v = static_cast<int>(std::lround(std::clamp(seen.y(), -1e6, 1e6)));
    const DepthRange range = range_at(model, u, v, point_sigma, settings);
    const double w = 1.0 / p.z();
    if (range.known() && w >= range.far && w <= range.near) return ScenePoint::kEnvironment;
    // What pixel statistics have missed: places that were seen at least from beside.
    if (model.occupied.near(p) && !(range.known() && w > range.near)) {
        return ScenePoint::kEnvironment;
    }
    if (!range.known()) return ScenePoint::kUnknown;
    return w > range.near ? ScenePoint::kInFront : ScenePoint::kBehind;
}

/// Standard deviation of the point's inverse depth; 0: unknown.
double inverse_depth_sigma(const Cloud& cloud, std::size_t i) {
    if (cloud.sigma.empty()) return 0.0;
    const Eigen::Vector3f& p = cloud.points[i];
    return static_cast<double>(cloud.sigma[i]) / static_cast<double>(p.norm() * p.z());
}

}  // namespace

double EnvironmentModel::known() const {
    if (pixels.empty()) return 0.0;
    const auto seen = std::count_if(pixels.begin(), pixels.end(),
                                    [](const EnvironmentPixel& p) { return p.views > 0; });
    return static_cast<double>(seen) / static_cast<double>(pixels.size());
}

Status EnvironmentModel::fits(const Cloud& cloud) const {
    if (!cloud.organised()) return {};
    if (cloud.grid_width != width || cloud.grid_height != height) {
        return input_error(
            "the environment was learned from images of {} x {} px, the scene has {} x {}: learn "
            "it again with this camera",
            width, height, cloud.grid_width, cloud.grid_height);
    }
    constexpr double kSameCamera_px = 0.5;
    const double misfit = misfit_px(cloud, camera);
    if (misfit <= kSameCamera_px) return {};
    return input_error(
        "the environment was learned with another calibration: the scene's points lie {:.1f} px "
        "from where they should; learn it again",
        misfit);
}

std::vector<ScenePoint> EnvironmentModel::classify(const Cloud& cloud,
                                                   const SubtractSettings& settings,
                                                   const ForEach& for_each,
                                                   const Pose& T_model_scene) const {
    std::vector<ScenePoint> kinds(cloud.size());
    for_each_block(cloud.size(), for_each, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            kinds[i] = kind_of(*this, T_model_scene * cloud.points[i].cast<double>(),
                               inverse_depth_sigma(cloud, i), settings);
        }
    });
    return kinds;
}

Result<std::vector<std::size_t>> EnvironmentModel::subtract(const Cloud& cloud,
                                                            const SubtractSettings& settings,
                                                            const ForEach& for_each,
                                                            const Pose& T_model_scene) const {
    if (Status same = fits(cloud); !same) return forward_error(same.error());
    const auto kinds = classify(cloud, settings, for_each, T_model_scene);
    std::vector<std::size_t> other;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] == ScenePoint::kInFront || kinds[i] == ScenePoint::kUnknown) {
            other.push_back(i);
        }
    }
    return other;
}

Cloud EnvironmentModel::cloud() const {
    Cloud cloud;
    cloud.grid_width = width;
    cloud.grid_height = height;
    cloud.viewpoint = Eigen::Vector3f::Zero();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const EnvironmentPixel& pixel = pixels[i];
        const double w = inverse_depth_per_m(pixel.mean);
        if (pixel.views == 0 || w <= 0.0) continue;
        const auto cell = static_cast<int>(i);
        const Eigen::Vector3d p = camera.point_m(cell % width, cell / width, 1.0 / w);
        cloud.points.push_back(p.cast<float>());
        cloud.intensity.push_back(static_cast<float>(pixel.grey));
        cloud.sigma.push_back(static_cast<float>(p.norm() * p.z() * sigma_per_m(pixel)));
        cloud.cell.push_back(cell);
    }
    return cloud;
}

bool operator==(const EnvironmentModel& a, const EnvironmentModel& b) {
    const auto numbers = [](const EnvironmentModel& m) {
        return std::vector<double>{m.camera.fu_px, m.camera.cu_px,       m.camera.fv_px,
                                   m.camera.cv_px, m.zero_per_m,         m.quantum_per_m,
                                   m.noise_per_m,  m.occupied.voxel_m(), m.arm.voxel_m()};
    };
    return a.width == b.width && a.height == b.height && numbers(a) == numbers(b) &&
           a.captures == b.captures && a.pixels == b.pixels &&
           a.occupied.keys() == b.occupied.keys() && a.arm.keys() == b.arm.keys();
}

}  // namespace gripscan
