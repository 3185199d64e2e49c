#include "core/registration/point_to_plane.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace gripscan {
namespace {

/// Tukey's constant for 95 % efficiency with normal errors.
constexpr float kTukey = 4.685F;
/// No pair is known better than this: rounding of floats and of the surface model, m.
constexpr float kSigmaFloor_m = 5e-6F;
/// Share of the largest curvature below which a direction counts as not tied down.
constexpr double kDamping = 1e-5;

struct Moved {
    Eigen::Matrix3f R;
    Eigen::Vector3f t;
    explicit Moved(const Pose& T) : R(T.linear().cast<float>()), t(T.translation().cast<float>()) {}
    [[nodiscard]] Eigen::Vector3f point(const Eigen::Vector3f& p) const { return R * p + t; }
};

/// Fills residual, sigma, normal; false where the two do not fit together.
bool complete(const Surface& source, const Surface& target, const Moved& moved, float min_cos,
              Match& m) {
    const Eigen::Vector3f n_source = moved.R * source.normals[m.source];
    const Eigen::Vector3f& n_target = target.normals[m.target];
    if (n_source.dot(n_target) < min_cos) return false;
    m.normal = (n_source + n_target).normalized();
    const Eigen::Vector3f p = moved.point(source.points[m.source]);
    const Eigen::Vector3f& q = target.points[m.target];
    m.residual_m = m.normal.dot(p - q);
    m.middle = 0.5F * (p + q);
    const Eigen::Vector3f n_in_source = moved.R.transpose() * m.normal;
    const float a = source.sigma_along(m.source, n_in_source);
    const float b = target.sigma_along(m.target, m.normal);
    m.sigma_m = std::sqrt(a * a + b * b + kSigmaFloor_m * kSigmaFloor_m);
    return true;
}

void weigh(std::vector<Match>& matches) {
    if (matches.empty()) return;
    std::vector<float> ratio(matches.size());
    for (std::size_t i = 0; i < matches.size(); ++i) {
        ratio[i] = std::abs(matches[i].residual_m) / matches[i].sigma_m;
    }
    std::vector<float> sorted = ratio;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const float scale = kTukey * std::max(1.0F, 1.4826F * *middle);
    for (std::size_t i = 0; i < matches.size(); ++i) {
        const float u = ratio[i] / scale;
        const float rest = 1.0F - u * u;
        matches[i].weight = u < 1.0F ? rest * rest : 0.0F;
    }
}

}  // namespace

std::vector<Match> match(const Surface& source, const Surface& target, const Samples& samples,
                         const Pose& T_target_source, const MatchingSettings& settings) {
    const Moved forward(T_target_source);
    const Moved backward(T_target_source.inverse());
    const auto gate = static_cast<float>(settings.gate_m);
    std::vector<Match> matches;
    matches.reserve(samples.source.size() + samples.target.size());
    for (const std::uint32_t i : samples.source) {
        if (settings.skip_rims && source.rim[i] != 0) continue;
        const auto found = target.tree.nearest_within(forward.point(source.points[i]), gate);
        if (!found || (settings.skip_rims && target.rim[found->index] != 0)) continue;
        Match m{.source = i, .target = found->index};
        if (complete(source, target, forward, settings.min_normal_cos, m)) matches.push_back(m);
    }
    for (const std::uint32_t j : samples.target) {
        if (settings.skip_rims && target.rim[j] != 0) continue;
        const auto found = source.tree.nearest_within(backward.point(target.points[j]), gate);
        if (!found || (settings.skip_rims && source.rim[found->index] != 0)) continue;
        Match m{.source = found->index, .target = j};
        if (complete(source, target, forward, settings.min_normal_cos, m)) matches.push_back(m);
    }
    weigh(matches);
    return matches;
}

Vector6d jacobian(const Match& match, const Eigen::Vector3d& centre) {
    const Eigen::Vector3d n = match.normal.cast<double>();
    Vector6d J;
    J.head<3>() = (match.middle.cast<double>() - centre).cross(n);
    J.tail<3>() = n;
    return J;
}

NormalEquations normal_equations(const std::vector<Match>& matches, const Eigen::Vector3d& centre) {
    NormalEquations sums;
    for (const Match& m : matches) {
        if (m.weight <= 0.0F) continue;
        const Vector6d J = jacobian(m, centre);
        const double sigma = m.sigma_m;
        const double w = m.weight / (sigma * sigma);
        sums.H.selfadjointView<Eigen::Lower>().rankUpdate(J, w);
        sums.g += (w * m.residual_m) * J;
        sums.weight += m.weight;
    }
    sums.H = sums.H.selfadjointView<Eigen::Lower>();
    return sums;
}

Pose refine(const Surface& source, const Surface& target, const Samples& samples, const Pose& start,
            const RefineSettings& settings) {
    Pose T = start;
    double gate_m = settings.first_gate_m;
    const double radius_m = std::max(target.radius_m, 1e-6);
    for (int iteration = 0; iteration < settings.iterations; ++iteration) {
        const auto matches = match(source, target, samples, T,
                                   {.gate_m = gate_m, .min_normal_cos = settings.min_normal_cos});
        if (matches.size() < 30) return T;
        const Eigen::Vector3d centre = T * source.centre_m;
        NormalEquations sums = normal_equations(matches, centre);
        // Rotations in units of the radius, so that one damping serves both kinds of unknowns.
        Vector6d scale = Vector6d::Ones();
        scale.head<3>().setConstant(1.0 / radius_m);
        Matrix6d H = scale.asDiagonal() * sums.H * scale.asDiagonal();
        H.diagonal().array() += kDamping * H.diagonal().maxCoeff();
        const Vector6d scaled = -H.ldlt().solve(scale.asDiagonal() * sums.g);
        const Vector6d motion = scale.asDiagonal() * scaled;
        if (!motion.allFinite()) return T;
        T = motion_about(motion, centre) * T;
        const bool narrow = gate_m <= settings.last_gate_m;
        gate_m = std::max(settings.last_gate_m, gate_m * settings.shrink);
        if (narrow && scaled.norm() / radius_m < settings.tolerance) break;
    }
    return T;
}

}  // namespace gripscan
