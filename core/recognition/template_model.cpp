#include "core/recognition/template_model.h"

#include <algorithm>
#include <cmath>

#include "core/cloud/filters.h"
#include "core/cloud/kd_tree.h"
#include "core/recognition/open_border.h"

namespace gripscan {
namespace {

constexpr std::size_t kFewestPoints = 100;
/// Beyond this many points the outside and the normals are no better known.
constexpr std::size_t kDensePoints = 30000;

double typical_spacing_m(const std::vector<Eigen::Vector3f>& points) {
    const KdTree tree(points);
    const std::size_t stride = std::max<std::size_t>(1, points.size() / 1000);
    std::vector<float> distances;
    std::vector<Neighbour> found;
    for (std::size_t i = 0; i < points.size(); i += stride) {
        tree.k_nearest(points[i], 5, found);
        // Four neighbours of a square grid lie at its spacing, whatever single pairs do.
        if (found.size() == 5) distances.push_back(std::sqrt(found[4].squared_distance_m2));
    }
    if (distances.empty()) return 0.0;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return static_cast<double>(*middle);
}

/// Which side is outside is not yet known where the cloud brought no normals.
OrientedPoints with_normals(const Cloud& cloud, const ForEach& for_each) {
    if (cloud.has_normals()) return {cloud.points, cloud.normals};
    Cloud computed;
    computed.points = cloud.points;
    estimate_normals(computed, {}, for_each);
    return {computed.points, computed.normals};
}

/// Normals of a scan that all look to one side only are the viewer's, not the part's.
OrientedPoints dense_outside(const Cloud& cloud, const ForEach& for_each) {
    OrientedPoints part = with_normals(cloud, for_each);
    double spacing_m = typical_spacing_m(part.points);
    if (part.size() > kDensePoints) {
        part = thinned_to(part, spacing_m, kDensePoints);
        spacing_m = typical_spacing_m(part.points);
    }
    return outside_of(part, cloud.has_normals(), spacing_m, for_each);
}

}  // namespace

Result<std::shared_ptr<const TemplateModel>> make_template_model(
    const std::string& name, const Cloud& cloud, const TemplateModelSettings& settings,
    const Progress& progress, const ForEach& for_each) {
    if (cloud.size() < kFewestPoints) {
        return input_error("template {}: only {} points; recognition wants at least {}", name,
                           cloud.size(), kFewestPoints);
    }
    auto model = std::make_shared<TemplateModel>();
    model->name = name;
    model->dense = dense_outside(cloud, for_each);
    model->diameter_m = diagonal_m(model->dense);
    if (!(model->diameter_m > 1e-4)) {
        return input_error("template {}: its points lie within {:.2g} mm; is the unit metres?",
                           name, 1e3 * model->diameter_m);
    }
    if (progress.cancelled()) return cancelled_error();
    const double dense_m = model->dense_m = typical_spacing_m(model->dense.points);
    model->dense_border = open_border(model->dense, dense_m, for_each);
    model->samples = thinned_to(model->dense, dense_m, settings.samples);
    model->spacing_m = typical_spacing_m(model->samples.points);
    model->step_m = settings.step_share * model->diameter_m;
    model->coarse = thinned_to(model->dense, model->step_m, settings.coarse_points);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& p : model->samples.points) sum += p.cast<double>();
    model->centre_m = (sum / static_cast<double>(model->samples.size())).cast<float>();
    model->pairs.emplace(model->coarse, model->step_m);
    model->coarse_seen.emplace(model->coarse, model->dense, dense_m, for_each);
    model->samples_seen.emplace(model->samples, model->dense, dense_m, for_each);
    if (progress.cancelled()) return cancelled_error();
    model->symmetry = find_symmetry(*model, for_each);
    return std::shared_ptr<const TemplateModel>(model);
}

}  // namespace gripscan
