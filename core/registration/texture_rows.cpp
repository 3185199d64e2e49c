#include "core/registration/texture_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/registration/masked_blur.h"

namespace gripscan {
namespace {

constexpr std::array<float, kTextureScales> kSmoothing_px{0.6F, 1.6F, 3.2F};
/// Window of the local mean and deviation, px.
constexpr std::array<float, kTextureScales> kWindow_px{4.0F, 6.0F, 9.0F};
/// Local deviation below which there is noise rather than texture, levels of 255.
constexpr float kLeastContrast = 2.0F;
/// Cosine of the steepest viewing angle at which texture is still comparable.
constexpr float kLeastFacing = 0.35F;
constexpr double kTukey = 4.685;
/// Texture differences smaller than this (in local deviations) are not to be had.
constexpr double kTextureFloor = 0.05;
constexpr std::size_t kFewestRows = 50;

/// View `to` warped into the grid of view `from`.
struct Warped {
    MaskedGrid grid;
    std::vector<float> value;
    std::vector<float> by_u;  ///< of `to`'s image, per px
    std::vector<float> by_v;
    std::vector<Eigen::Vector3f> where;  ///< the point, frame of `to`
};

bool facing(const Surface& s, std::size_t i) {
    return s.rim[i] == 0 && -s.normals[i].dot(s.rays[i]) > kLeastFacing;
}

Warped warp(const Surface& from, const Surface& to, const Pose& T_to_from, float gate_m) {
    const TextureGrid& grid = *from.texture;
    const std::size_t cells = grid.points().size();
    Warped w{.grid = {grid.width(), grid.height(), std::vector<float>(cells, 0.0F)},
             .value = std::vector<float>(cells, 0.0F),
             .by_u = std::vector<float>(cells, 0.0F),
             .by_v = std::vector<float>(cells, 0.0F),
             .where = std::vector<Eigen::Vector3f>(cells, Eigen::Vector3f::Zero())};
    const Eigen::Matrix3f R = T_to_from.linear().cast<float>();
    const Eigen::Vector3f t = T_to_from.translation().cast<float>();
    for (std::size_t cell = 0; cell < cells; ++cell) {
        if (grid.points()[cell] < 0) continue;
        const auto i = static_cast<std::size_t>(grid.points()[cell]);
        if (!facing(from, i)) continue;
        const Eigen::Vector3f p = R * from.points[i] + t;
        const auto seen = to.texture->look(p);
        if (!seen || seen->point < 0) continue;
        const auto j = static_cast<std::size_t>(seen->point);
        if (!facing(to, j) || std::abs(to.points[j].z() - p.z()) > gate_m) continue;
        w.grid.mask[cell] = 1.0F;
        w.value[cell] = seen->value;
        w.by_u[cell] = seen->by_u;
        w.by_v[cell] = seen->by_v;
        w.where[cell] = p;
    }
    return w;
}

/// Brightness freed of light, and the deviation it was divided by.
struct Pattern {
    std::vector<float> value;
    std::vector<float> deviation;
};

Pattern pattern(const std::vector<float>& brightness, const MaskedGrid& grid,
                const MaskedBlur& smoothing, const MaskedBlur& window) {
    Pattern p{smoothing(brightness), {}};
    const std::vector<float> mean = window(p.value);
    std::vector<float> squares(mean.size());
    for (std::size_t i = 0; i < mean.size(); ++i) {
        p.value[i] = grid.mask[i] > 0.0F ? p.value[i] - mean[i] : 0.0F;
        squares[i] = p.value[i] * p.value[i];
    }
    p.deviation = window(squares);
    for (std::size_t i = 0; i < mean.size(); ++i) {
        p.deviation[i] = std::max(kLeastContrast, std::sqrt(p.deviation[i]));
        p.value[i] /= p.deviation[i];
    }
    return p;
}

/// One direction. The motion is that of the source about the centre in the target frame;
/// T_target_to and sign say how `to` sees it.
void compare(const Surface& from, const Surface& to, const Pose& T_to_from, int scale, float gate_m,
             const Pose& T_target_to, double sign, const Eigen::Vector3d& centre,
             std::vector<ResidualRow>& rows) {
    const Warped w = warp(from, to, T_to_from, gate_m);
    const auto k = static_cast<std::size_t>(scale);
    const MaskedBlur smoothing(w.grid, kSmoothing_px[k]);
    const MaskedBlur window(w.grid, kWindow_px[k]);
    std::vector<float> own = from.texture->brightness();
    for (std::size_t i = 0; i < own.size(); ++i) own[i] *= w.grid.mask[i];
    const Pattern here = pattern(own, w.grid, smoothing, window);
    const Pattern there = pattern(w.value, w.grid, smoothing, window);
    const std::vector<float> by_u = smoothing(w.by_u);
    const std::vector<float> by_v = smoothing(w.by_v);
    const Eigen::Matrix3d R = T_target_to.linear();
    const auto width = static_cast<std::size_t>(w.grid.width);
    for (std::size_t i = 0; i < own.size(); ++i) {
        // Every second cell, like the black fields of a chessboard: neighbours say the same.
        if (w.grid.mask[i] <= 0.0F || (i % width + i / width) % 2 != 0) continue;
        ResidualRow row;
        row.residual = there.value[i] - here.value[i];
        const Eigen::Vector3f gradient = to.texture->gradient_at(w.where[i], by_u[i], by_v[i]);
        const Eigen::Vector3d g = sign / there.deviation[i] * (R * gradient.cast<double>());
        const Eigen::Vector3d where = T_target_to * w.where[i].cast<double>();
        row.J.head<3>() = (where - centre).cross(g);
        row.J.tail<3>() = g;
        row.where = where.cast<float>();
        rows.push_back(row);
    }
}

void weigh(std::vector<ResidualRow>& rows) {
    if (rows.size() < kFewestRows) {
        rows.clear();
        return;
    }
    std::vector<double> size;
    size.reserve(rows.size());
    for (const ResidualRow& row : rows) size.push_back(std::abs(row.residual));
    const auto middle = size.begin() + static_cast<std::ptrdiff_t>(size.size() / 2);
    std::nth_element(size.begin(), middle, size.end());
    const double sigma = std::max(kTextureFloor, 1.4826 * *middle);
    for (ResidualRow& row : rows) {
        const double u = row.residual / (kTukey * sigma);
        const double rest = 1.0 - u * u;
        row.information = std::abs(u) < 1.0 ? rest * rest / (sigma * sigma) : 0.0;
    }
}

}  // namespace

std::vector<ResidualRow> texture_rows(const Surface& source, const Surface& target,
                                      const Pose& T_target_source, int scale, double gate_m,
                                      const Eigen::Vector3d& centre) {
    std::vector<ResidualRow> rows;
    if (!source.texture || !target.texture) return rows;
    const auto gate = static_cast<float>(gate_m);
    compare(source, target, T_target_source, scale, gate, Pose::Identity(), 1.0, centre, rows);
    // Moving the source is, seen from the source, moving the target the other way.
    compare(target, source, T_target_source.inverse(), scale, gate, T_target_source, -1.0, centre,
            rows);
    weigh(rows);
    return rows;
}

}  // namespace gripscan
