#include "core/recognition/pose_refinement.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/recognition/predicted_view.h"
#include "core/registration/point_to_plane.h"

namespace gripscan {
namespace {

constexpr float kTukey = 4.685F;
constexpr std::size_t kFewestPartners = 12;
/// Standard deviation of an edge in units of a surface point's.
constexpr float kEdgeSigma = 4.0F;
/// Share of the largest curvature added to all: directions the view does not tie down stay put.
constexpr double kDamping = 1e-4;

float robust_spread(const std::vector<Match>& matches) {
    std::vector<float> sizes;
    sizes.reserve(matches.size());
    for (const Match& m : matches) sizes.push_back(std::abs(m.residual_m));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return 1.4826F * *middle;
}

/// Tukey's biweight at a scale from the median, never below `floor`.
void weigh(std::vector<Match>& matches, float floor) {
    const float scale = kTukey * std::max(floor, robust_spread(matches));
    for (Match& m : matches) {
        const float u = m.residual_m / scale;
        const float rest = 1.0F - u * u;
        m.weight = std::abs(u) < 1.0F ? rest * rest : 0.0F;
    }
}

void add_partner(const Eigen::Vector3f& p, const Eigen::Vector3f& n, const Eigen::Vector3f& q,
                 const Eigen::Vector3f& m, float min_cos, std::vector<Match>& matches) {
    if (n.dot(m) < min_cos) return;
    Match match;
    match.normal = (n + m).normalized();
    match.residual_m = match.normal.dot(p - q);
    match.middle = 0.5F * (p + q);
    match.sigma_m = 1.0F;
    matches.push_back(match);
}

struct Moved {
    Eigen::Matrix3f R;
    Eigen::Vector3f t;
    explicit Moved(const Pose& T) : R(T.linear().cast<float>()), t(T.translation().cast<float>()) {}
    [[nodiscard]] Eigen::Vector3f point(const Eigen::Vector3f& p) const { return R * p + t; }
};

/// The equations with rotations in units of the radius.
struct Scaled {
    Matrix6d H;
    Vector6d g;
};
Scaled scaled_equations(const std::vector<Match>& matches, const Eigen::Vector3d& centre,
                        double radius_m) {
    const NormalEquations sums = normal_equations(matches, centre);
    Vector6d scale = Vector6d::Ones();
    scale.head<3>().setConstant(1.0 / radius_m);
    return {scale.asDiagonal() * sums.H * scale.asDiagonal(), scale.asDiagonal() * sums.g};
}

/// One step; returns its size in m at the radius.
double step(const std::vector<Match>& matches, const Eigen::Vector3d& centre, double radius_m,
            Pose& T) {
    Scaled eq = scaled_equations(matches, centre, radius_m);
    eq.H.diagonal().array() += kDamping * eq.H.diagonal().maxCoeff();
    const Vector6d scaled = -eq.H.ldlt().solve(eq.g);
    if (!scaled.allFinite()) return 0.0;
    Vector6d motion = scaled;
    motion.head<3>() /= radius_m;
    T = motion_about(motion, centre) * T;
    return scaled.norm();
}

struct Gates {
    double first_m;
    double last_m;
    double shrink;
    int iterations;
    double tolerance_m;  ///< a step smaller than this ends it
};

/// partners(T, gate, matches) finds them at the pose T; more(T, matches) adds such that bring
/// weights of their own.
template <typename Partners, typename More>
Pose iterate(const Pose& start, const Eigen::Vector3f& centre, double radius_m, const Gates& gates,
             Partners partners, More more) {
    Pose T = start;
    double gate_m = gates.first_m;
    std::vector<Match> matches;
    for (int i = 0; i < gates.iterations; ++i) {
        matches.clear();
        partners(T, static_cast<float>(gate_m), matches);
        if (matches.size() < kFewestPartners) return T;
        weigh(matches, static_cast<float>(0.2 * gates.last_m));
        more(T, matches);
        const double moved_m = step(matches, T * centre.cast<double>(), radius_m, T);
        const bool narrow = gate_m <= gates.last_m;
        gate_m = std::max(gates.last_m, gate_m * gates.shrink);
        if (narrow && moved_m < gates.tolerance_m) break;
    }
    return T;
}

constexpr auto kNoMore = [](const Pose&, std::vector<Match>&) {};

double radius_of(const TemplateModel& model) {
    return 0.35 * model.diameter_m;
}

void partners_in_view(const PredictedView& view, const SceneView& scene, float gate,
                      std::vector<Match>& matches) {
    constexpr float kMinCos = 0.7F;
    for (const PredictedSample& s : view.samples) {
        if (!scene.map.inside(s.at.column, s.at.row)) continue;
        const std::int32_t k = scene.map.point_at(s.at.column, s.at.row);
        if (k < 0) continue;
        const Eigen::Vector3f& q = scene.points.points[static_cast<std::size_t>(k)];
        if ((s.point - q).squaredNorm() > gate * gate) continue;
        add_partner(s.point, s.normal, q, scene.points.normals[static_cast<std::size_t>(k)],
                    kMinCos, matches);
    }
}

/// Where the part's outline meets the edges of what was measured: ties down flat parts within
/// their plane. Stereo makes all silhouettes wider or narrower by about the same; that is taken
/// out by the median.
void partners_of_outline(const PredictedView& view, const SceneView& scene, float tolerance,
                         std::vector<Match>& matches) {
    const Eigen::Vector3f across = scene.map.across();
    const Eigen::Vector3f down = scene.map.down();
    std::vector<Match> edges;
    std::vector<float> offsets;
    const int reach = 2 * view.cell + 2;
    for (const OutlinePoint& point : view.outline) {
        const auto cells = edge_offset(view, scene, point, tolerance, reach);
        if (!cells) continue;
        const PredictedSample& s = view.samples[point.sample];
        Match m;
        m.normal = point.outward.x() * across + point.outward.y() * down;
        m.middle = s.point;
        m.residual_m = -*cells * s.at.depth_m / scene.map.cells_per_unit();
        offsets.push_back(m.residual_m);
        edges.push_back(m);
    }
    constexpr std::size_t kFewestEdges = 20;
    if (edges.size() < kFewestEdges) return;
    const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::nth_element(offsets.begin(), middle, offsets.end());
    for (Match& m : edges) m.residual_m -= *middle;
    weigh(edges, 0.5F * tolerance);
    // An edge is known several times worse than a surface: to some pixels.
    for (Match& m : edges) m.sigma_m = kEdgeSigma;
    matches.insert(matches.end(), edges.begin(), edges.end());
}

}  // namespace

Pose refine_coarsely(const TemplateModel& model, const CoarseScene& scene,
                     const Eigen::Vector3f& viewpoint, const Pose& start) {
    const Gates gates{3.0 * model.step_m, 1.2 * model.step_m, 0.75, 12, 0.02 * model.step_m};
    return iterate(
        start, model.centre_m, radius_of(model), gates,
        [&](const Pose& T, float gate, std::vector<Match>& matches) {
            const Moved move(T);
            const Eigen::Vector3f towards =
                (move.R.transpose() * (viewpoint - move.point(model.centre_m))).normalized();
            for (const std::uint32_t i : model.coarse_seen->visible(towards)) {
                const Eigen::Vector3f p = move.point(model.coarse.points[i]);
                const auto found = scene.tree.nearest_within(p, gate);
                if (!found) continue;
                add_partner(p, move.R * model.coarse.normals[i], scene.points.points[found->index],
                            scene.points.normals[found->index], 0.5F, matches);
            }
        },
        kNoMore);
}

FineRefinement refine_finely(const TemplateModel& model, const SceneView& scene, const Pose& start,
                             double first_gate_m, double last_gate_m) {
    const Gates gates{first_gate_m, last_gate_m, 0.7, 20, 2e-5};
    PredictedView view;
    const auto partners = [&](const Pose& T, float gate, std::vector<Match>& matches) {
        view = predict_view(model, scene, T);
        partners_in_view(view, scene, gate, matches);
    };
    const auto outline = [&](const Pose&, std::vector<Match>& matches) {
        partners_of_outline(view, scene, static_cast<float>(last_gate_m), matches);
    };
    FineRefinement result;
    result.T_scene_template =
        iterate(start, model.centre_m, radius_of(model), gates, partners, outline);
    std::vector<Match> matches;
    partners(result.T_scene_template, static_cast<float>(last_gate_m), matches);
    if (matches.size() < kFewestPartners) return result;
    result.spread_m = static_cast<double>(robust_spread(matches));
    weigh(matches, static_cast<float>(0.2 * last_gate_m));
    double sum = 0.0;
    double weights = 0.0;
    for (const Match& m : matches) {
        if (m.weight <= 0.0F) continue;
        sum += static_cast<double>(m.residual_m) * static_cast<double>(m.residual_m);
        weights += 1.0;
    }
    result.rms_m = std::sqrt(sum / std::max(1.0, weights));
    const Scaled eq = scaled_equations(
        matches, result.T_scene_template * model.centre_m.cast<double>(), radius_of(model));
    const Vector6d values =
        Eigen::SelfAdjointEigenSolver<Matrix6d>(eq.H, Eigen::EigenvaluesOnly).eigenvalues();
    if (values(5) > 0.0) result.tied_down = std::max(0.0, values(0) / values(5));
    return result;
}

Pose refine_onto(const OrientedPoints& moving, const OrientedPoints& still,
                 const KdTree& still_tree, const Pose& start, double first_gate_m,
                 double last_gate_m) {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    for (const auto& p : moving.points) centre += p;
    centre /= static_cast<float>(std::max<std::size_t>(1, moving.size()));
    const Gates gates{first_gate_m, last_gate_m, 0.7, 20, 1e-5};
    return iterate(
        start, centre, std::max(1e-6, 0.35 * diagonal_m(moving)), gates,
        [&](const Pose& T, float gate, std::vector<Match>& matches) {
            const Moved move(T);
            for (std::size_t i = 0; i < moving.size(); ++i) {
                const Eigen::Vector3f p = move.point(moving.points[i]);
                const auto found = still_tree.nearest_within(p, gate);
                if (!found) continue;
                add_partner(p, move.R * moving.normals[i], still.points[found->index],
                            still.normals[found->index], 0.5F, matches);
            }
        },
        kNoMore);
}

}  // namespace gripscan
