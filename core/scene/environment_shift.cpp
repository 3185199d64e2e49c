#include "core/scene/environment_shift.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/depth_image.h"

namespace gripscan {
namespace {

using Vector8d = Eigen::Matrix<double, 8, 1>;
using Matrix8d = Eigen::Matrix<double, 8, 8>;

/// From coarse to fine: pixels made one, and how far points may be from the environment, in shares
/// of the reach.
struct Stage {
    int factor;
    double reach;
};
constexpr std::array<Stage, 4> kStages = {{{8, 1.0}, {4, 0.6}, {2, 0.3}, {2, 0.2}}};
constexpr int kIterations = 12;
constexpr std::size_t kMostPlaces = 60000;
constexpr std::size_t kFewestPlaces = 400;
/// Refinement windows make disparities of neighbours err alike over about so many pixels.
constexpr double kDepthCorrelation_px = 12.0;
/// The lens and averaging make brightness err alike over about so many.
constexpr double kGreyCorrelation_px = 3.0;

/// What is estimated: a small motion about `centre`, and exposure: model · gain + offset = scene.
struct Estimate {
    Pose T_model_scene = Pose::Identity();
    double gain = 1.0;
    double offset = 0.0;
};

/// One place of the scene against the model.
struct Place {
    double depth = 0.0;  ///< residual of the inverse depth, 1/m
    double grey = 0.0;   ///< residual of the brightness, levels
    Vector8d depth_slope = Vector8d::Zero();
    Vector8d grey_slope = Vector8d::Zero();
};

struct Comparison {
    const DepthImage& model;
    const DepthImage& scene;
    Eigen::Vector3d centre;
    double reach_m;
    std::size_t stride;
};

std::optional<Place> place_at(const Comparison& c, const Estimate& estimate, int u, int v) {
    const std::size_t i = c.scene.at(u, v);
    const double w = static_cast<double>(c.scene.inverse_depth_per_m[i]);
    if (w <= 0.0) return std::nullopt;
    const Eigen::Vector3d q = estimate.T_model_scene * c.scene.camera.point_m(u, v, 1.0 / w);
    if (q.z() <= 0.0) return std::nullopt;
    const Eigen::Vector2d seen = c.model.camera.project(q);
    const auto m = sample(c.model, seen.x(), seen.y());
    if (!m) return std::nullopt;
    Place place;
    place.depth = m->inverse_depth - 1.0 / q.z();
    if (std::abs(place.depth) * q.z() * q.z() > c.reach_m) return std::nullopt;
    place.grey = estimate.gain * m->grey + estimate.offset - static_cast<double>(c.scene.grey[i]);
    const double fu = c.model.camera.fu_px / q.z();
    const double fv = c.model.camera.fv_px / q.z();
    const Eigen::Vector3d du(fu, 0.0, -fu * q.x() / q.z());
    const Eigen::Vector3d dv(0.0, fv, -fv * q.y() / q.z());
    const auto slope = [&](const Eigen::Vector3d& by_point) {
        Vector8d s = Vector8d::Zero();
        s.head<3>() = (q - c.centre).cross(by_point);
        s.segment<3>(3) = by_point;
        return s;
    };
    place.depth_slope = slope(m->inverse_depth_u * du + m->inverse_depth_v * dv +
                              Eigen::Vector3d(0, 0, 1.0 / (q.z() * q.z())));
    place.grey_slope = slope(estimate.gain * (m->grey_u * du + m->grey_v * dv));
    place.grey_slope(6) = m->grey;
    place.grey_slope(7) = 1.0;
    return place;
}

std::vector<Place> places(const Comparison& c, const Estimate& estimate, const ForEach& for_each) {
    const auto rows = static_cast<std::size_t>(c.scene.height);
    std::vector<std::vector<Place>> found(rows);
    for_each(rows, [&](std::size_t row) {
        const auto stride = static_cast<int>(c.stride);
        for (int u = static_cast<int>(row) % stride; u < c.scene.width; u += stride) {
            if (const auto place = place_at(c, estimate, u, static_cast<int>(row))) {
                found[row].push_back(*place);
            }
        }
    });
    std::vector<Place> all;
    for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// Standard deviation of normal residuals that have this median length.
double robust_sigma(const std::vector<Place>& all, double Place::*residual, double least) {
    std::vector<double> lengths;
    lengths.reserve(all.size());
    for (const Place& place : all) lengths.push_back(std::abs(place.*residual));
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return std::max(least, 1.4826 * *middle);
}

double tukey(double residual, double sigma) {
    const double r = residual / (4.685 * sigma);
    return std::abs(r) < 1.0 ? (1.0 - r * r) * (1.0 - r * r) : 0.0;
}

struct System {
    Matrix8d information = Matrix8d::Zero();
    Vector8d pull = Vector8d::Zero();
    std::size_t agreeing = 0;
};

/// `independent`: by how much neighbours that err alike count less, for depth and for brightness.
System system_of(const std::vector<Place>& all, const std::array<double, 2>& independent) {
    System system;
    const double depth_sigma = robust_sigma(all, &Place::depth, 1e-5);
    const double grey_sigma = robust_sigma(all, &Place::grey, 0.5);
    for (const Place& place : all) {
        const double in_depth = tukey(place.depth, depth_sigma);
        if (in_depth == 0.0) continue;
        ++system.agreeing;
        const double a = independent[0] * in_depth / (depth_sigma * depth_sigma);
        // Where the surface is another one, its brightness says nothing.
        const double b =
            independent[1] * in_depth * tukey(place.grey, grey_sigma) / (grey_sigma * grey_sigma);
        system.information.noalias() += a * place.depth_slope * place.depth_slope.transpose();
        system.information.noalias() += b * place.grey_slope * place.grey_slope.transpose();
        system.pull.noalias() += a * place.depth * place.depth_slope;
        system.pull.noalias() += b * place.grey * place.grey_slope;
    }
    // Without texture gain and offset are as they were.
    system.information(6, 6) += 1e2;
    system.information(7, 7) += 1e-2;
    return system;
}

double independent_share(double correlation_px, double spacing_px) {
    const double ratio = spacing_px / correlation_px;
    return std::min(1.0, ratio * ratio);
}

Eigen::Vector3d middle_of(const DepthImage& image) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double n = 0.0;
    for (int v = 0; v < image.height; ++v) {
        for (int u = 0; u < image.width; ++u) {
            const double w = static_cast<double>(image.inverse_depth_per_m[image.at(u, v)]);
            if (w <= 0.0) continue;
            sum += image.camera.point_m(u, v, 1.0 / w);
            n += 1.0;
        }
    }
    return n > 0.0 ? Eigen::Vector3d(sum / n) : Eigen::Vector3d(0, 0, 1);
}

/// Iterates at one scale; nothing if too little can be compared.
std::optional<System> refine(const Comparison& c, const std::array<double, 2>& independent,
                             const ForEach& for_each, Estimate& estimate, std::size_t& count) {
    std::optional<System> last;
    for (int i = 0; i < kIterations; ++i) {
        const auto all = places(c, estimate, for_each);
        count = all.size();
        if (all.size() < kFewestPlaces) return std::nullopt;
        last = system_of(all, independent);
        const Vector8d step = -last->information.ldlt().solve(last->pull);
        if (!step.allFinite()) return std::nullopt;
        estimate.T_model_scene = motion_about(step.head<6>(), c.centre) * estimate.T_model_scene;
        estimate.gain = std::clamp(estimate.gain + step(6), 0.3, 3.0);
        estimate.offset += step(7);
        constexpr double kStill_m = 2e-6;
        constexpr double kStill_rad = 2e-6;
        if (step.head<3>().norm() < kStill_rad && step.segment<3>(3).norm() < kStill_m) break;
    }
    return last;
}

void conclude(const System& system, const Estimate& estimate, const Eigen::Vector3d& centre,
              std::size_t count, const ShiftSettings& settings, EnvironmentShift& shift) {
    shift.known = true;
    shift.places = count;
    shift.agreeing = static_cast<double>(system.agreeing) / static_cast<double>(count);
    shift.T_model_scene = estimate.T_model_scene;
    shift.at_m = centre;
    shift.shift_m = estimate.T_model_scene.inverse() * centre - centre;
    shift.turn_rad = rotation_angle_rad(estimate.T_model_scene.linear());
    const Matrix8d covariance = system.information.inverse();
    shift.sd_rad = std::sqrt(covariance.topLeftCorner<3, 3>().trace());
    shift.sd_m = std::sqrt(covariance.block<3, 3>(3, 3).trace());
    const double length = shift.shift_m.norm();
    // A turn about the middle moves what is half a metre away.
    constexpr double kAway_m = 0.5;
    const bool shifted = length > settings.least_m && length > settings.sigmas * shift.sd_m;
    const bool turned = shift.turn_rad * kAway_m > settings.least_m &&
                        shift.turn_rad > settings.sigmas * shift.sd_rad;
    shift.moved = shifted || turned;
}

}  // namespace

Result<EnvironmentShift> environment_shift(const EnvironmentModel& model, const Cloud& scene,
                                           const ShiftSettings& settings, const Progress& progress,
                                           const ForEach& for_each) {
    if (!scene.organised()) {
        return input_error("a shift of the environment is found in images: the cloud has no grid");
    }
    if (Status same = model.fits(scene); !same) return forward_error(same.error());
    const DepthImage learned = image_of(model);
    const DepthImage now = image_of(scene, model.camera);
    const Eigen::Vector3d centre = middle_of(learned);
    Estimate estimate;
    EnvironmentShift shift;
    for (const Stage& stage : kStages) {
        if (progress.cancelled()) return cancelled_error();
        const DepthImage small_model = shrunk(learned, stage.factor, for_each);
        const DepthImage small_scene = shrunk(now, stage.factor, for_each);
        const auto pixels = small_scene.grey.size();
        const std::size_t stride = pixels / kMostPlaces + 1;
        const double spacing_px = stage.factor * std::sqrt(static_cast<double>(stride));
        const std::array<double, 2> independent = {
            independent_share(kDepthCorrelation_px, spacing_px),
            independent_share(kGreyCorrelation_px, spacing_px)};
        std::size_t count = 0;
        const auto system =
            refine({small_model, small_scene, centre, stage.reach * settings.reach_m, stride},
                   independent, for_each, estimate, count);
        if (!system) return EnvironmentShift{};
        conclude(*system, estimate, centre, count, settings, shift);
    }
    return shift;
}

}  // namespace gripscan
