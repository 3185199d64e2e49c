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
/// What a cell without any measurement speaks against a pose, in seen ones: stereo leaves holes.
constexpr double kUnknownShare = 0.6;
/// Cosine of the angle to the line of sight up to which a surface should be measured.
constexpr float kFacing = 0.6F;
/// What a measurement that contradicts speaks against a pose, in seen ones: a part that is there is
/// contradicted by some per cent, one of about its shape by tens.
constexpr double kAgainst = 3.0;
/// How often such a cell counts that has its like all around.
constexpr int kSolid = 3;
/// What a surface that adjoins the outline speaks against it: parts are held, and lie on tables.
constexpr double kBendsShare = 0.7;

/// Nearer in front than this share of the part's size is no other thing standing before it: the
/// surface is another one than the part's.
constexpr double kGap = 0.08;

/// Steps to the neighbours of a cell.
constexpr std::array<std::array<int, 2>, 4> kAround{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

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
    if (k < 0) return Sighting::kUnknown;
    const auto i = static_cast<std::size_t>(k);
    const Eigen::Vector3f& there = scene.points.normals[i];
    const float off_plane = std::abs(there.dot(point - scene.points.points[i]));
    const float behind = scene.map.depth_m(i) - at.depth_m;
    if (off_plane <= tolerance.surface_m && std::abs(behind) <= 4.0F * tolerance.surface_m) {
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

/// The comparison of the predicted depth image with the measured one.
class Comparison {
  public:
    Comparison(const TemplateModel& model, const SceneView& scene, const Pose& T, double tolerance_m)
        : scene_(scene),
          predicted_(model, scene, T),
          tolerance_{static_cast<float>(tolerance_m),
                     static_cast<float>(std::max(kGap * model.diameter_m, 4.0 * tolerance_m))},
          edge_(edge_cells(model, scene, T)) {}

    [[nodiscard]] VisibleAgreement run(std::vector<std::uint32_t>* claimed) const {
        VisibleAgreement a;
        for (int r = predicted_.first_row(); r < predicted_.first_row() + predicted_.height(); ++r) {
            const int end = predicted_.first_column() + predicted_.width();
            for (int c = predicted_.first_column(); c < end; ++c) {
                const std::int32_t i = predicted_.at(c, r);
                if (i < 0) continue;
                surface(c, r, i, a, claimed);
                outline(c, r, i, a);
            }
        }
        return a;
    }

  private:
    static int edge_cells(const TemplateModel& model, const SceneView& scene, const Pose& T) {
        const Eigen::Vector3f centre = (T * model.centre_m.cast<double>()).cast<float>();
        const float depth_m = std::max(1e-3F, scene.map.place_of(centre).depth_m);
        const auto detail_m = static_cast<float>(kEdgeDetail * model.diameter_m);
        const float cells = detail_m * scene.map.cells_per_unit() / depth_m;
        return std::clamp(static_cast<int>(std::lround(std::min(cells, 100.0F))), 1, kEdge);
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
        // Stereo seldom measures a surface that it sees obliquely: there nothing measured is nothing
        // learnt.
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
    void outline(int c, int r, std::int32_t i, VisibleAgreement& a) const {
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
            beyond(c + (edge_ + 1) * dc, r + (edge_ + 1) * dr, i, a);
        }
    }

    void beyond(int c, int r, std::int32_t i, VisibleAgreement& a) const {
        if (!scene_.map.inside(c, r) || predicted_.at(c, r) >= 0) return;
        const std::int32_t k = scene_.map.point_at(c, r);
        if (k < 0) {
            ++a.outline_open;
            return;
        }
        const auto q = static_cast<std::size_t>(k);
        const float off_plane = std::abs(normal(i).dot(scene_.points.points[q] - point(i)));
        const float beyond_m = scene_.map.depth_m(q) - predicted_.depth_m(i);
        if (off_plane <= 2.0F * tolerance_.surface_m &&
            scene_.points.normals[q].dot(normal(i)) > kSamePlane) {
            ++a.outline_goes_on;
        } else if (beyond_m > tolerance_.gap_m) {
            ++a.outline_ends;
        } else if (beyond_m > -tolerance_.gap_m) {
            ++a.outline_bends;  // else something stands in front, which says nothing
        }
    }

    const SceneView& scene_;
    PredictedDepth predicted_;
    Tolerance tolerance_;
    int edge_;
};

}  // namespace

double VisibleAgreement::support() const {
    const double judged =
        seen + kAgainst * (contradicted + mismatched) + kUnknownShare * unknown;
    return judged > 0.0 ? seen / judged : 0.0;
}

double VisibleAgreement::found() const {
    return visible > 0 ? static_cast<double>(seen) / visible : 0.0;
}

double VisibleAgreement::outline() const {
    const double ends = outline_ends + outline_open;
    // Some undecided cells are added: an outline that nobody can judge has shown little.
    constexpr double kUndecided = 10.0;
    return (ends + 0.5 * kUndecided) /
           (ends + outline_goes_on + kBendsShare * outline_bends + kUndecided);
}

double VisibleAgreement::score() const {
    return support() * outline();
}

std::string VisibleAgreement::terms() const {
    return fmt::format(
        "visible {} seen {} hidden {} through {} mismatched {} unknown {} outline ends {} open {} "
        "bends {} goes on {} | support {:.2f} outline {:.2f}",
        visible, seen, hidden, contradicted, mismatched, unknown, outline_ends, outline_open,
        outline_bends, outline_goes_on, support(), outline());
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

}  // namespace gripscan
