// The static environment as a camera that does not move has seen it: per pixel the range of depths
// and their deviation, per voxel whether something was there. It tells which points of a later
// scene are the environment's and which are not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/scene/pinhole.h"
#include "core/scene/voxel_set.h"

namespace gripscan {

/// What a point of a scene is to the environment.
enum class ScenePoint : std::uint8_t {
    kEnvironment,  ///< where the environment is, to its deviation
    kInFront,      ///< nearer than the environment: something has come
    kBehind,       ///< seen through where it was: something has gone, or a false match
    kUnknown,      ///< nothing was learned there
};

struct SubtractSettings {
    double sigmas = 4.0;  ///< of deviation of pixel and point together
    /// Depths of so many pixels around count as the pixel's own, and all between them: at an edge
    /// a pixel sees now one side, now the other, now something in between.
    int edge_px = 2;
};

/// Depths of one pixel, as inverse depth: there the noise of stereo is the same everywhere.
/// 1/Z = zero_per_m + number · quantum_per_m.
struct EnvironmentPixel {
    std::uint16_t mean = 0;
    std::uint16_t far = 0;   ///< mean of the farthest surface seen here, and
    std::uint16_t near = 0;  ///< of the nearest: two where an edge flickers
    std::uint8_t sigma = 0;  ///< standard deviation of one observation, in 2 quanta
    std::uint8_t views = 0;  ///< captures that saw it; 0: nothing is known here
    std::uint8_t grey = 0;   ///< mean brightness

    friend bool operator==(const EnvironmentPixel&, const EnvironmentPixel&) = default;
};

struct EnvironmentModel {
    int width = 0;
    int height = 0;
    Pinhole camera;
    double zero_per_m = 0.0;
    double quantum_per_m = 1.0;
    double noise_per_m = 0.0;  ///< usual standard deviation of an inverse depth
    int captures = 0;
    std::vector<EnvironmentPixel> pixels;  ///< row by row
    VoxelSet occupied;                     ///< where the environment was seen at all
    VoxelSet arm;  ///< where, before it, the arm was seen while it stood elsewhere every time

    [[nodiscard]] double inverse_depth_per_m(std::uint16_t number) const {
        return zero_per_m + quantum_per_m * number;
    }
    [[nodiscard]] double sigma_per_m(const EnvironmentPixel& pixel) const {
        return 2.0 * quantum_per_m * pixel.sigma;
    }
    /// Nothing is known outside the image.
    [[nodiscard]] EnvironmentPixel at(int u, int v) const {
        if (u < 0 || v < 0 || u >= width || v >= height) return {};
        return pixels[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(u)];
    }
    /// Share of the pixels of which something is known.
    [[nodiscard]] double known() const;

    /// Was the cloud taken by this camera? Errors: another grid, or points that this camera would
    /// see elsewhere (a new calibration).
    [[nodiscard]] Status fits(const Cloud& cloud) const;

    /// Of every point; the cloud is in the camera frame, organised or not. `T_model_scene` moves it
    /// to where the environment stood when it was learned (see environment_shift.h).
    [[nodiscard]] std::vector<ScenePoint> classify(
        const Cloud& cloud, const SubtractSettings& settings, const ForEach& for_each,
        const Pose& T_model_scene = Pose::Identity()) const;

    /// Indices of the points that are not the environment's: in front of it or where nothing was
    /// learned. Errors: as fits().
    [[nodiscard]] Result<std::vector<std::size_t>> subtract(
        const Cloud& cloud, const SubtractSettings& settings = {},
        const ForEach& for_each = for_each_in_order,
        const Pose& T_model_scene = Pose::Identity()) const;

    /// The environment as a cloud: mean depths, deviation, brightness; organised.
    [[nodiscard]] Cloud cloud() const;

    friend bool operator==(const EnvironmentModel&, const EnvironmentModel&);
};

}  // namespace gripscan
