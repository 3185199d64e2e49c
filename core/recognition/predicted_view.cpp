#include "core/recognition/predicted_view.h"

#include <algorithm>
#include <cmath>

namespace gripscan {
namespace {

/// The samples as a picture of coarse cells; −1 where there is none.
class SamplePicture {
  public:
    SamplePicture(const std::vector<PredictedSample>& samples, int cell) : cell_(cell) {
        int high_c = -(1 << 30);
        int high_r = -(1 << 30);
        low_c_ = low_r_ = 1 << 30;
        for (const PredictedSample& s : samples) {
            low_c_ = std::min(low_c_, s.at.column);
            high_c = std::max(high_c, s.at.column);
            low_r_ = std::min(low_r_, s.at.row);
            high_r = std::max(high_r, s.at.row);
        }
        // Two empty cells all around, so that every neighbourhood lies inside.
        width_ = (high_c - low_c_) / cell_ + 5;
        height_ = (high_r - low_r_) / cell_ + 5;
        nearest_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), -1);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            std::int32_t& at = nearest_[index((samples[i].at.column - low_c_) / cell_ + 2,
                                              (samples[i].at.row - low_r_) / cell_ + 2)];
            if (at < 0 ||
                samples[static_cast<std::size_t>(at)].at.depth_m > samples[i].at.depth_m) {
                at = static_cast<std::int32_t>(i);
            }
        }
    }

    [[nodiscard]] std::vector<OutlinePoint> outline() const {
        std::vector<OutlinePoint> points;
        for (int r = 2; r + 2 < height_; ++r) {
            for (int c = 2; c + 2 < width_; ++c) {
                if (!filled(c, r)) continue;
                // Away from what is filled around; a gap between samples has no such direction.
                Eigen::Vector2f inward = Eigen::Vector2f::Zero();
                for (int dr = -2; dr <= 2; ++dr) {
                    for (int dc = -2; dc <= 2; ++dc) {
                        if (filled(c + dc, r + dr)) {
                            inward +=
                                Eigen::Vector2f(static_cast<float>(dc), static_cast<float>(dr));
                        }
                    }
                }
                constexpr float kLopsided = 8.0F;  // a straight outline gives 15 to 20
                if (inward.norm() < kLopsided) continue;
                const Eigen::Vector2f out = -inward.normalized();
                const int next_c = c + static_cast<int>(std::lround(1.3F * out.x()));
                const int next_r = r + static_cast<int>(std::lround(1.3F * out.y()));
                if (filled(next_c, next_r)) continue;
                points.push_back({static_cast<std::size_t>(nearest_[index(c, r)]), out});
            }
        }
        return points;
    }

  private:
    [[nodiscard]] std::size_t index(int c, int r) const {
        return static_cast<std::size_t>(r) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(c);
    }
    [[nodiscard]] bool filled(int c, int r) const { return nearest_[index(c, r)] >= 0; }

    int cell_;
    int low_c_ = 0, low_r_ = 0, width_ = 0, height_ = 0;
    std::vector<std::int32_t> nearest_;
};

enum class Edge { kSurface, kBeyond, kInFront };

Edge edge_at(const SceneView& scene, const PredictedSample& s, float column, float row,
             float tolerance_m) {
    const int c = static_cast<int>(std::lround(column));
    const int r = static_cast<int>(std::lround(row));
    if (!scene.map.inside(c, r)) return Edge::kInFront;
    const std::int32_t k = scene.map.point_at(c, r);
    if (k < 0) {
        return scene.map.in_shadow(c, r, s.at.depth_m - tolerance_m) ? Edge::kInFront
                                                                     : Edge::kBeyond;
    }
    const auto i = static_cast<std::size_t>(k);
    const float off_plane = s.normal.dot(scene.points.points[i] - s.point);
    if (std::abs(off_plane) <= tolerance_m) return Edge::kSurface;
    return scene.map.depth_m(i) < s.at.depth_m - tolerance_m ? Edge::kInFront : Edge::kBeyond;
}

}  // namespace

PredictedView predict_view(const TemplateModel& model, const SceneView& scene,
                           const Pose& T_scene_template) {
    PredictedView view;
    float depth_m = 0.0F;
    for_each_visible(model.samples, *model.samples_seen, scene, model.centre_m, T_scene_template,
                     [&](const PredictedSample& s) {
                         view.samples.push_back(s);
                         depth_m += s.at.depth_m;
                     });
    if (view.samples.empty()) return view;
    depth_m /= static_cast<float>(view.samples.size());
    // Two spacings: samples thin out towards the outline, where the surface turns away.
    view.cell = std::max(1, static_cast<int>(std::ceil(2.0F * static_cast<float>(model.spacing_m) *
                                                       scene.map.cells_per_unit() / depth_m)));
    // A part whose picture would fill millions of cells is no prediction to be judged.
    view.outline = SamplePicture(view.samples, view.cell).outline();
    return view;
}

std::optional<float> edge_offset(const PredictedView& view, const SceneView& scene,
                                 const OutlinePoint& from, float tolerance_m, int reach) {
    const PredictedSample& s = view.samples[from.sample];
    const auto look = [&](int k) {
        return edge_at(
            scene, s, static_cast<float>(s.at.column) + static_cast<float>(k) * from.outward.x(),
            static_cast<float>(s.at.row) + static_cast<float>(k) * from.outward.y(), tolerance_m);
    };
    const Edge here = look(0);
    if (here == Edge::kInFront) return std::nullopt;
    if (here == Edge::kSurface) {
        for (int k = 1; k <= reach; ++k) {
            const Edge edge = look(k);
            if (edge == Edge::kInFront) return std::nullopt;
            if (edge == Edge::kBeyond) return static_cast<float>(k) - 0.5F;
        }
        return std::nullopt;
    }
    for (int k = 1; k <= reach; ++k) {
        const Edge edge = look(-k);
        if (edge == Edge::kInFront) return std::nullopt;
        if (edge == Edge::kSurface) return 0.5F - static_cast<float>(k);
    }
    return std::nullopt;
}

}  // namespace gripscan
