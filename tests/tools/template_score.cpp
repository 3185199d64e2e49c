#include "tests/tools/template_score.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/cloud/kd_tree.h"

namespace gripscan::test {
namespace {

double at_share(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

TemplateScore score_template(const Cloud& points, const Pose& T_first_template,
                             const Truth& truth) {
    TemplateScore score;
    score.points = points.size();
    if (points.empty()) return score;
    const Cloud cloud = transformed(points, T_first_template);

    const SurfaceDistance surface(truth.surface);
    std::vector<double> distances_mm;
    double sum = 0.0;
    for (const Eigen::Vector3f& p : cloud.points) {
        distances_mm.push_back(surface.distance_m(p.cast<double>()) * kMmPerM);
        sum += distances_mm.back() * distances_mm.back();
    }
    std::sort(distances_mm.begin(), distances_mm.end());
    score.rms_mm = std::sqrt(sum / static_cast<double>(distances_mm.size()));
    score.p50_mm = at_share(distances_mm, 0.50);
    score.p90_mm = at_share(distances_mm, 0.90);
    score.p99_mm = at_share(distances_mm, 0.99);
    score.max_mm = distances_mm.back();

    constexpr float kNear_m = 0.001F;
    const KdTree tree(cloud.points);
    const auto covered =
        std::count_if(truth.visible.points.begin(), truth.visible.points.end(),
                      [&](const auto& p) { return tree.nearest_within(p, kNear_m).has_value(); });
    score.coverage = static_cast<double>(covered) /
                     static_cast<double>(std::max<std::size_t>(truth.visible.size(), 1));
    return score;
}

}  // namespace gripscan::test
