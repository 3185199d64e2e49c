#include "tests/tools/template_score.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/cloud/kd_tree.h"

namespace gripscan::test {
namespace {

/// Where object and gripper touch, a point belongs to both.
constexpr double kSame_mm = 0.5;
/// Further off than this a point is no noise of the surface.
constexpr double kOff_mm = 2.0;

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
    std::optional<SurfaceDistance> whole;
    if (truth.whole) whole.emplace(*truth.whole);
    std::vector<double> distances_mm;
    double sum = 0.0;
    std::size_t foreign = 0;
    for (const Eigen::Vector3f& p : cloud.points) {
        const double own_mm = surface.distance_m(p.cast<double>()) * kMmPerM;
        // What is nearest of all that turns is the object itself, or lies nearer than it does.
        if (whole) {
            const double any_mm = whole->distance_m(p.cast<double>()) * kMmPerM;
            if (own_mm > any_mm + kSame_mm || own_mm > kOff_mm) ++foreign;
        }
        distances_mm.push_back(own_mm);
        sum += own_mm * own_mm;
    }
    score.foreign = static_cast<double>(foreign) / static_cast<double>(cloud.size());
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
