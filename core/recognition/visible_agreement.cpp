#include "core/recognition/visible_agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/recognition/predicted_depth.h"
#include "core/recognition/predicted_view.h"

namespace gripscan {
namespace {

/// Cosine of the largest angle between normals of the same spot.
constexpr float kSameNormal = 0.64F;
/// A surface that goes on across an outline does not bend by more than this (cosine).
constexpr float kSamePlane = 0.94F;
/// Cells by which stereo may misplace an edge: half of a matching window. In coarse views it is not
/// more than a detail of the part, in shares of its size.
constexpr int kEdge = 3;
constexpr double kEdgeDetail = 0.02;
/// Cosine of the angle to the line of sight up to which a surface should be measured.
constexpr float kFacing = 0.6F;
constexpr AgreementWeights kOwnStereo{.contradicts = 3.0,
                                      .mismatches = 0.6,
                                      .unknown = 0.7,
                                      .open = 1.0,
                                      .bends = 0.2,
                                      .strays = 6.0,
                                      .goes_on = 6.0,
                                      .support_power = 1.5,
                                      .outline_power = 1.5,
                                      .found_power = 0.0,
                                      .least_outline = 0.0};
constexpr AgreementWeights kOtherDepth{.contradicts = 1.0,
                                       .mismatches = 1.0,
                                       .unknown = 0.3,
                                       .open = 0.7,
                                       .bends = 0.0,
                                       .strays = 0.0,
                                       .goes_on = 1.0,
                                       .support_power = 1.0,
                                       .outline_power = 2.0,
                                       .found_power = 0.5,
                                       .least_outline = 0.95};
/// How often such a cell counts that has its like all around.
constexpr int kSolid = 3;
/// Cells by which an edge may differ from where the others are.
constexpr int kStray = 1;
/// Cells outwards within which an edge is looked for: half a matching window and some.
constexpr int kReach = 8;
/// The same in spacings of the template's samples, where nothing is known of the camera's edges.
constexpr double kReachSpacings = 4.0;
/// The share of strays that stereo makes by itself.
constexpr double kUsualStrays = 0.3;

/// Nearer in front than this share of the part's size is no other thing standing before it: the
/// surface is another one than the part's.
constexpr double kGap = 0.04;

/// Steps to the neighbours of a cell.
constexpr std::array<std::array<int, 2>, 4> kAround{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Cells by which a point may be seen beside where it is predicted.
constexpr float kCellsAlong = 1.5F;

enum class Sighting { kSeen, kHidden, kContradicted, kMismatched, kUnknown };

struct Tolerance {
    float surface_m;  ///< off the plane
    float gap_m;      ///< in front: another thing
};

/// What the map holds where a point of the part should be seen.
Sighting look(const SceneView& scene, const Eigen::Vector3f& point, const Eigen::Vector3f& normal,
              const ViewMap::Place& at, const Tolerance& tolerance) {
    if (!scene.map.inside(at.column, at.row)) return Sighting::kUnknown;
    const std::int32_t k = scene.map.point_at(at.column, at.row);
    if (k < 0) {
        return scene.map.in_shadow(at.column, at.row, at.depth_m - tolerance.gap_m)
                   ? Sighting::kHidden
                   : Sighting::kUnknown;
    }
    const auto i = static_cast<std::size_t>(k);
    const Eigen::Vector3f& there = scene.points.normals[i];
    const float off_plane = std::abs(there.dot(point - scene.points.points[i]));
    const float behind = scene.map.depth_m(i) - at.depth_m;
    // Along a surface that is seen flatly the depth changes much from one cell to the next.
    const float facing = std::max(0.1F, normal.dot((scene.map.viewpoint() - point).normalized()));
    const float cell_m = at.depth_m / scene.map.cells_per_unit();
    const float along_m = std::max(4.0F * tolerance.surface_m, kCellsAlong * cell_m / facing);
    if (off_plane <= tolerance.surface_m && std::abs(behind) <= along_m) {
        return there.dot(normal) > kSameNormal ? Sighting::kSeen : Sighting::kMismatched;
    }
    if (behind > 0.0F) return Sighting::kContradicted;
    return behind < -tolerance.gap_m ? Sighting::kHidden : Sighting::kMismatched;
}

void count(Sighting sighting, VisibleAgreement& a) {
    ++a.visible;
    switch (sighting) {
        case Sighting::kSeen:
            ++a.seen;
            break;
        case Sighting::kHidden:
            ++a.hidden;
            break;
        case Sighting::kContradicted:
            ++a.contradicted;
            break;
        case Sighting::kMismatched:
            ++a.mismatched;
            break;
        case Sighting::kUnknown:
            ++a.unknown;
            break;
    }
}

/// What is seen across an edge of the part.
enum class Beyond { kSurface, kHidden, kOpen, kBehind, kBeside };
struct Edge {
    bool border;  ///< of the template only, perhaps
    int offset;   ///< cells outwards from where the part ends
    Beyond kind;
};

/// The comparison of the predicted depth image with the measured one.
class Comparison {
  public:
    Comparison(const TemplateModel& model, const SceneView& scene, const Pose& T,
               double tolerance_m)
        : scene_(scene),
          predicted_(model, scene, T),
          tolerance_{static_cast<float>(tolerance_m),
                     static_cast<float>(std::max(kGap * model.diameter_m, 4.0 * tolerance_m))},
          edge_(cells_of(kEdgeDetail * model.diameter_m, 1, kEdge, model, scene, T)),
          reach_(reach_cells(model, T)) {}

    [[nodiscard]] VisibleAgreement run(std::vector<std::uint32_t>* claimed) const {
        VisibleAgreement a;
        a.weights = &weights_for(scene_);
        std::vector<Edge> edges;
        for (int r = predicted_.first_row(); r < predicted_.first_row() + predicted_.height();
             ++r) {
            const int end = predicted_.first_column() + predicted_.width();
            for (int c = predicted_.first_column(); c < end; ++c) {
                const std::int32_t i = predicted_.at(c, r);
                if (i < 0) continue;
                surface(c, r, i, a, claimed);
                outline(c, r, i, a, edges);
            }
        }
        count_edges(std::move(edges), a);
        return a;
    }

  private:
    /// A length at the part's distance, in cells.
    static int cells_of(double length_m, int least, int most, const TemplateModel& model,
                        const SceneView& scene, const Pose& T) {
        const Eigen::Vector3f centre = (T * model.centre_m.cast<double>()).cast<float>();
        const float depth_m = std::max(1e-3F, scene.map.place_of(centre).depth_m);
        const float cells = static_cast<float>(length_m) * scene.map.cells_per_unit() / depth_m;
        return std::clamp(static_cast<int>(std::lround(std::min(cells, 100.0F))), least, most);
    }

    /// Our stereo's windows have so many pixels; what smooths another camera's edges is unknown.
    [[nodiscard]] int reach_cells(const TemplateModel& model, const Pose& T) const {
        if (scene_.noise_told) return kReach - 2 * (kEdge - edge_);
        return cells_of(kReachSpacings * model.spacing_m, 2, 3 * kReach, model, scene_, T);
    }

    [[nodiscard]] const Eigen::Vector3f& point(std::int32_t i) const {
        return predicted_.surface().points[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const Eigen::Vector3f& normal(std::int32_t i) const {
        return predicted_.surface().normals[static_cast<std::size_t>(i)];
    }

    void surface(int c, int r, std::int32_t i, VisibleAgreement& a,
                 std::vector<std::uint32_t>* claimed) const {
        const Sighting found =
            look(scene_, point(i), normal(i), {c, r, predicted_.depth_m(i)}, tolerance_);
        if (claimed != nullptr && found == Sighting::kSeen) {
            claimed->push_back(static_cast<std::uint32_t>(scene_.map.point_at(c, r)));
        }
        if (near_edge(c, r, i)) return;
        // Stereo seldom measures a surface that it sees obliquely: there nothing measured is
        // nothing learnt.
        if (found == Sighting::kUnknown && !faces_camera(i)) return;
        count(found, a);
        if (speaks_against(found) && solid(c, r)) {
            for (int more = 1; more < kSolid; ++more) count(found, a);
        }
    }

    static bool speaks_against(Sighting sighting) {
        return sighting == Sighting::kContradicted || sighting == Sighting::kMismatched;
    }

    /// All around too: errors of stereo along edges are thin, what is missing of a part is not.
    [[nodiscard]] bool solid(int c, int r) const {
        for (const auto& [dc, dr] : kAround) {
            const int column = c + edge_ * dc;
            const int row = r + edge_ * dr;
            const std::int32_t j = predicted_.at(column, row);
            if (j < 0) return false;
            if (!speaks_against(look(scene_, point(j), normal(j),
                                     {column, row, predicted_.depth_m(j)}, tolerance_))) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] bool faces_camera(std::int32_t i) const {
        const Eigen::Vector3f towards = (scene_.map.viewpoint() - point(i)).normalized();
        return normal(i).dot(towards) > kFacing;
    }

    /// Stereo makes edges wider or narrower by some cells: beside them nothing is judged.
    [[nodiscard]] bool near_edge(int c, int r, std::int32_t i) const {
        for (const auto& [dc, dr] : kAround) {
            const std::int32_t j = predicted_.at(c + edge_ * dc, r + edge_ * dr);
            if (j < 0) return true;
            const float step_m = std::abs(normal(i).dot(point(j) - point(i)));
            if (step_m > tolerance_.gap_m) return true;
        }
        return false;
    }

    /// Does the scene's surface end where the part does, or go on as if there were no edge?
    void outline(int c, int r, std::int32_t i, VisibleAgreement& a,
                 std::vector<Edge>& edges) const {
        for (const auto& [dc, dr] : kAround) {
            if (predicted_.at(c + dc, r + dr) >= 0) continue;
            // Only where the part is found before its edge.
            const int inside_c = c - edge_ * dc;
            const int inside_r = r - edge_ * dr;
            const std::int32_t j = predicted_.at(inside_c, inside_r);
            if (j < 0) continue;
            if (look(scene_, point(j), normal(j), {inside_c, inside_r, predicted_.depth_m(j)},
                     tolerance_) != Sighting::kSeen) {
                continue;
            }
            if (part_again(c, r, dc, dr)) continue;
            // Another camera's edges are anywhere near: only well beyond can be looked.
            for (int k = scene_.noise_told ? 1 - edge_ : reach_; k <= reach_; ++k) {
                const Beyond there = beyond(c + k * dc, r + k * dr, i);
                if (there == Beyond::kSurface && k < reach_) continue;
                const bool border = predicted_.border(i);
                if (there == Beyond::kSurface && !border) ++a.outline_goes_on;
                if (there != Beyond::kSurface && there != Beyond::kHidden) {
                    edges.push_back({border, k, there});
                }
                break;
            }
        }
    }

    /// A gap in the predicted picture, or a notch of the part: no outline to be judged.
    [[nodiscard]] bool part_again(int c, int r, int dc, int dr) const {
        for (int k = 1; k <= reach_; ++k) {
            if (predicted_.at(c + k * dc, r + k * dr) >= 0) return true;
        }
        return false;
    }

    /// What is seen at that cell, as the plane of the part's surface at i has it.
    [[nodiscard]] Beyond beyond(int c, int r, std::int32_t i) const {
        if (!scene_.map.inside(c, r)) return Beyond::kHidden;
        const std::int32_t k = scene_.map.point_at(c, r);
        if (k < 0) {
            return scene_.map.in_shadow(c, r, predicted_.depth_m(i) - tolerance_.gap_m)
                       ? Beyond::kHidden
                       : Beyond::kOpen;
        }
        const auto q = static_cast<std::size_t>(k);
        const float off_plane = std::abs(normal(i).dot(scene_.points.points[q] - point(i)));
        const float beyond_m = scene_.map.depth_m(q) - predicted_.depth_m(i);
        if (off_plane <= 2.0F * tolerance_.surface_m &&
            scene_.points.normals[q].dot(normal(i)) > kSamePlane) {
            return Beyond::kSurface;
        }
        if (beyond_m > tolerance_.gap_m) return Beyond::kBehind;
        return beyond_m > -tolerance_.gap_m ? Beyond::kBeside : Beyond::kHidden;
    }

    /// Stereo makes all silhouettes wider or narrower by about the same; an edge that is not where
    /// the others are is that of another thing.
    void count_edges(std::vector<Edge> edges, VisibleAgreement& a) const {
        if (edges.empty()) return;
        const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
        std::nth_element(edges.begin(), middle, edges.end(),
                         [](const Edge& x, const Edge& y) { return x.offset < y.offset; });
        const int median = middle->offset;
        for (const Edge& e : edges) {
            if (scene_.noise_told && std::abs(e.offset - median) > kStray + kEdge - edge_) {
                if (!e.border) ++a.outline_strays;
            } else if (e.kind == Beyond::kOpen) {
                ++a.outline_open;
            } else if (e.kind == Beyond::kBehind || !scene_.noise_told) {
                ++a.outline_ends;
            } else {
                ++a.outline_bends;
            }
        }
    }

    const SceneView& scene_;
    PredictedDepth predicted_;
    Tolerance tolerance_;
    int edge_;   ///< cells that stereo may misplace an edge by
    int reach_;  ///< cells outwards within which one is looked for
};

}  // namespace

const AgreementWeights& weights_for(const SceneView& scene) {
    return scene.noise_told ? kOwnStereo : kOtherDepth;
}

double VisibleAgreement::support() const {
    if (weights == nullptr || seen == 0) return 0.0;
    return seen / (seen + weights->contradicts * contradicted + weights->mismatches * mismatched +
                   weights->unknown * unknown);
}

double VisibleAgreement::found() const {
    return visible > 0 ? static_cast<double>(seen) / visible : 0.0;
}

double VisibleAgreement::outline() const {
    if (weights == nullptr) return 0.0;
    const double ends = outline_ends + weights->open * outline_open;
    const double all = ends + outline_bends + outline_strays + outline_goes_on;
    const double strays = std::max(0.0, outline_strays - kUsualStrays * all);
    // Some undecided cells are added: an outline that nobody can judge has shown little.
    constexpr double kUndecided = 4.0;
    return (ends + 0.5 * kUndecided) /
           (ends + weights->strays * strays + weights->goes_on * outline_goes_on +
            weights->bends * outline_bends + kUndecided);
}

double VisibleAgreement::score() const {
    if (weights == nullptr) return 0.0;
    return std::pow(support(), weights->support_power) *
           std::pow(outline(), weights->outline_power) * std::pow(found(), weights->found_power);
}

std::string VisibleAgreement::terms() const {
    return fmt::format(
        "visible {} seen {} hidden {} through {} mismatched {} unknown {} outline ends {} open {} "
        "bends {} goes on {} strays {} | support {:.2f} outline {:.2f}",
        visible, seen, hidden, contradicted, mismatched, unknown, outline_ends, outline_open,
        outline_bends, outline_goes_on, outline_strays, support(), outline());
}

VisibleAgreement rough_agreement(const TemplateModel& model, const SceneView& scene,
                                 const Pose& T_scene_template, double tolerance_m) {
    VisibleAgreement a;
    const Tolerance tolerance{static_cast<float>(tolerance_m),
                              static_cast<float>(kGap * model.diameter_m)};
    for_each_visible(model.coarse, *model.coarse_seen, scene, model.centre_m, T_scene_template,
                     [&](const PredictedSample& s) {
                         count(look(scene, s.point, s.normal, s.at, tolerance), a);
                     });
    return a;
}

VisibleAgreement full_agreement(const TemplateModel& model, const SceneView& scene,
                                const Pose& T_scene_template, double tolerance_m,
                                std::vector<std::uint32_t>* claimed) {
    VisibleAgreement a = Comparison(model, scene, T_scene_template, tolerance_m).run(claimed);
    if (claimed != nullptr) {
        std::sort(claimed->begin(), claimed->end());
        claimed->erase(std::unique(claimed->begin(), claimed->end()), claimed->end());
    }
    return a;
}

bool Duel::decisive() const {
    constexpr double kSigmas = 2.5;
    constexpr double kTogether = 10.0;  // neighbouring cells err as one
    const double n = (first + second) / kTogether;
    return std::abs(first - second) / kTogether > kSigmas * std::sqrt(std::max(n, 0.1));
}

Duel duel(const TemplateModel& model, const SceneView& scene, const Pose& T_first,
          const Pose& T_second, double tolerance_m) {
    const Tolerance tolerance{static_cast<float>(tolerance_m),
                              static_cast<float>(4.0 * tolerance_m)};
    const PredictedDepth a(model, scene, T_first);
    const PredictedDepth b(model, scene, T_second);
    const auto speaks = [&](const PredictedDepth& view, std::int32_t i, int c, int r) {
        if (i < 0) return 0;
        const auto k = static_cast<std::size_t>(i);
        switch (look(scene, view.surface().points[k], view.surface().normals[k],
                     {c, r, view.depth_m(i)}, tolerance)) {
            case Sighting::kSeen:
                return 1;
            case Sighting::kContradicted:
            case Sighting::kMismatched:
                return -1;
            case Sighting::kHidden:
            case Sighting::kUnknown:
                break;
        }
        return 0;
    };
    Duel result;
    const int left = std::min(a.first_column(), b.first_column());
    const int top = std::min(a.first_row(), b.first_row());
    const int right = std::max(a.first_column() + a.width(), b.first_column() + b.width());
    const int bottom = std::max(a.first_row() + a.height(), b.first_row() + b.height());
    for (int r = top; r < bottom; ++r) {
        for (int c = left; c < right; ++c) {
            const std::int32_t i = a.at(c, r);
            const std::int32_t j = b.at(c, r);
            if (i < 0 && j < 0) continue;
            if (i >= 0 && j >= 0 &&
                std::abs(a.depth_m(i) - b.depth_m(j)) < 2.0F * tolerance.surface_m) {
                continue;
            }
            const int more = speaks(a, i, c, r) - speaks(b, j, c, r);
            if (more > 0) ++result.first;
            if (more < 0) ++result.second;
        }
    }
    return result;
}

}  // namespace gripscan
