#include "core/scene/environment_learner.h"

#include <algorithm>
#include <cmath>

#include "core/scene/pixel_history.h"

namespace gripscan {
namespace {

using Planes = std::vector<std::vector<float>>;

/// What the pixel saw, far ones first.
void history_at(const Planes& planes, std::size_t pixel, std::vector<double>& values) {
    values.clear();
    for (const auto& plane : planes) {
        if (plane[pixel] > 0.0F) values.push_back(static_cast<double>(plane[pixel]));
    }
    std::sort(values.begin(), values.end());
}

/// Median over a sample of pixels that were seen at least three times.
double usual_noise(const Planes& planes) {
    constexpr std::size_t kSample = 200000;
    const std::size_t pixels = planes.front().size();
    const std::size_t stride = pixels / kSample + 1;
    std::vector<double> variances;
    std::vector<double> values;
    for (std::size_t i = 0; i < pixels; i += stride) {
        history_at(planes, i, values);
        if (values.size() >= 3) variances.push_back(variance_for_median(values));
    }
    if (variances.size() < 100) return 0.0;
    const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
    std::nth_element(variances.begin(), middle, variances.end());
    return std::sqrt(*middle);
}

using Surfaces = std::vector<PixelSurface>;  ///< views = 0: nothing is known

Surfaces all_surfaces(const Planes& planes, int width, const HistorySettings& settings,
                      const ForEach& for_each) {
    const auto columns = static_cast<std::size_t>(width);
    Surfaces surfaces(planes.front().size());
    for_each(surfaces.size() / columns, [&](std::size_t row) {
        std::vector<double> values;
        for (std::size_t i = row * columns; i < (row + 1) * columns; ++i) {
            history_at(planes, i, values);
            if (const auto found = environment_of(values, settings)) surfaces[i] = *found;
        }
    });
    return surfaces;
}

/// Scale of the stored numbers: 16 bits from the farthest to the nearest.
void set_scale(EnvironmentModel& model, const Surfaces& surfaces) {
    double far = std::numeric_limits<double>::infinity();
    double near = 0.0;
    for (const PixelSurface& s : surfaces) {
        if (s.views == 0) continue;
        far = std::min(far, s.far);
        near = std::max(near, s.near);
    }
    model.zero_per_m = far;
    model.quantum_per_m = std::max((near - far) / 65535.0, 1e-9);
}

EnvironmentPixel stored(const EnvironmentModel& model, const PixelSurface& surface) {
    EnvironmentPixel pixel;
    if (surface.views == 0) return pixel;
    const auto number = [&](double w) {
        const double q = std::round((w - model.zero_per_m) / model.quantum_per_m);
        return static_cast<std::uint16_t>(std::clamp(q, 0.0, 65535.0));
    };
    pixel.mean = number(surface.mean);
    pixel.far = number(surface.far);
    pixel.near = number(surface.near);
    const double sigma = std::ceil(surface.sigma / (2.0 * model.quantum_per_m));
    pixel.sigma = static_cast<std::uint8_t>(std::clamp(sigma, 1.0, 255.0));
    pixel.views = static_cast<std::uint8_t>(std::min(surface.views, 255));
    return pixel;
}

/// Cubes in which the environment was seen: its pixels' depths, and what single captures saw if
/// there are two of them.
VoxelSet seen_somewhere(const Planes& planes, const Surfaces& surfaces, const Pinhole& camera,
                        int width, const LearnSettings& settings) {
    std::vector<Eigen::Vector3f> sure;
    std::vector<Eigen::Vector3f> single;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const int u = static_cast<int>(i) % width;
        const int v = static_cast<int>(i) / width;
        const auto at = [&](double w) -> Eigen::Vector3f {
            return camera.point_m(u, v, 1.0 / w).cast<float>();
        };
        if (surfaces[i].views > 0) {
            sure.push_back(at(surfaces[i].mean));
            sure.push_back(at(surfaces[i].far));
            sure.push_back(at(surfaces[i].near));
        } else if (!settings.arm_in_view) {
            for (const auto& plane : planes) {
                if (plane[i] > 0.0F) single.push_back(at(static_cast<double>(plane[i])));
            }
        }
    }
    VoxelSet occupied = VoxelSet::of(settings.voxel_m, sure, 1);
    occupied.merge(VoxelSet::of(settings.voxel_m, single, 2));
    return occupied;
}

/// Cubes in which something stood before the environment, capture by capture.
VoxelSet seen_before(const Planes& planes, const Surfaces& surfaces, const EnvironmentModel& model,
                     const LearnSettings& settings) {
    constexpr std::size_t kFewestPoints = 4;
    constexpr double kBefore_sigmas = 6.0;
    VoxelSet arm;
    for (const auto& plane : planes) {
        std::vector<Eigen::Vector3f> points;
        for (std::size_t i = 0; i < plane.size(); ++i) {
            const double w = static_cast<double>(plane[i]);
            const PixelSurface& s = surfaces[i];
            if (w <= 0.0 || s.views == 0 || w < s.near + kBefore_sigmas * s.sigma) continue;
            const int cell = static_cast<int>(i);
            const Eigen::Vector3d p =
                model.camera.point_m(cell % model.width, cell / model.width, 1.0 / w);
            if (settings.region && settings.region->contains(p)) continue;
            points.push_back(p.cast<float>());
        }
        arm.merge(VoxelSet::of(settings.voxel_m, points, kFewestPoints));
    }
    return arm;
}

}  // namespace

Status EnvironmentLearner::add(const Cloud& cloud) {
    if (!cloud.organised()) {
        return input_error(
            "the environment is learned from images: a cloud without the grid of its image "
            "cannot be used");
    }
    if (planes_.empty()) {
        const auto camera = pinhole_of(cloud);
        if (!camera) {
            return input_error(
                "the first capture shows too little to learn an environment from ({} points): is "
                "the lens covered, or the light off?",
                cloud.size());
        }
        camera_ = *camera;
        width_ = cloud.grid_width;
        height_ = cloud.grid_height;
        grey_sum_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
        seen_.assign(grey_sum_.size(), 0);
    }
    if (cloud.grid_width != width_ || cloud.grid_height != height_ ||
        misfit_px(cloud, camera_) > 0.5) {
        return input_error("capture {} was taken with another camera than the ones before",
                           planes_.size());
    }
    if (planes_.size() >= 255)
        return input_error("an environment is learned from at most 255 captures");
    std::vector<float> plane(grey_sum_.size(), 0.0F);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (cloud.points[i].z() <= 0.0F) continue;
        const auto cell = static_cast<std::size_t>(cloud.cell[i]);
        plane[cell] = 1.0F / cloud.points[i].z();
        if (cloud.intensity.empty()) continue;
        grey_sum_[cell] = static_cast<std::uint16_t>(
            grey_sum_[cell] + std::lround(std::clamp(cloud.intensity[i], 0.0F, 255.0F)));
        ++seen_[cell];
    }
    planes_.push_back(std::move(plane));
    return {};
}

Result<EnvironmentModel> EnvironmentLearner::finish(const Progress& progress,
                                                    const ForEach& for_each) const {
    if (captures() < settings_.fewest_captures) {
        return input_error(
            "an environment needs at least {} captures to tell noise from surfaces; there are {}",
            settings_.fewest_captures, captures());
    }
    progress.tell("learn environment", 0, 3);
    EnvironmentModel model;
    model.width = width_;
    model.height = height_;
    model.camera = camera_;
    model.captures = captures();
    model.noise_per_m = usual_noise(planes_);
    const Surfaces surfaces =
        all_surfaces(planes_, width_, {model.noise_per_m, settings_.arm_in_view}, for_each);
    if (progress.cancelled()) return cancelled_error();
    progress.tell("learn environment", 1, 3);
    set_scale(model, surfaces);
    model.pixels.resize(surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        model.pixels[i] = stored(model, surfaces[i]);
        if (surfaces[i].views > 0 && seen_[i] > 0) {
            model.pixels[i].grey = static_cast<std::uint8_t>(grey_sum_[i] / seen_[i]);
        }
    }
    constexpr double kHardlyAnything = 0.01;
    if (model.known() < kHardlyAnything || model.noise_per_m <= 0.0) {
        return input_error(
            "hardly anything of the environment was seen twice ({:.1f} % of the image): is the "
            "camera still, the light on, the lens clean?",
            100.0 * model.known());
    }
    model.occupied = seen_somewhere(planes_, surfaces, camera_, width_, settings_);
    if (progress.cancelled()) return cancelled_error();
    progress.tell("learn environment", 2, 3);
    if (settings_.arm_in_view) model.arm = seen_before(planes_, surfaces, model, settings_);
    progress.tell("learn environment", 3, 3);
    return model;
}

}  // namespace gripscan
