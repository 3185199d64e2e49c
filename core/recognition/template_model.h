// A template made ready to be found in scenes: once per template, then only read.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/recognition/oriented_points.h"
#include "core/recognition/pair_table.h"
#include "core/recognition/seen_from.h"
#include "core/recognition/symmetry.h"

namespace gripscan {

/// Immutable; shared between threads.
struct TemplateModel {
    std::string name;
    OrientedPoints dense;            ///< the surface as seen from outside, template frame
    std::vector<char> dense_border;  ///< where the template ends, though the part may go on
    OrientedPoints samples;          ///< points that a pose is verified and refined by
    OrientedPoints coarse;           ///< points that vote
    double dense_m = 0.0;            ///< spacing of the dense points
    double spacing_m = 0.0;          ///< of the samples
    double step_m = 0.0;             ///< of the coarse points
    double diameter_m = 0.0;
    Eigen::Vector3f centre_m = Eigen::Vector3f::Zero();
    std::optional<PairTable> pairs;
    std::optional<SeenFrom> coarse_seen;
    std::optional<SeenFrom> samples_seen;
    Symmetry symmetry;
};

struct TemplateModelSettings {
    double step_share = 0.05;         ///< distance of the coarse points, of the diameter
    std::size_t coarse_points = 500;  ///< at most
    std::size_t samples = 4000;       ///< at most
};

/// Normals are computed where the cloud has none, points inside the part are left out, symmetries
/// are found. Errors: fewer than 100 points, or no extent; cancelled.
[[nodiscard]] Result<std::shared_ptr<const TemplateModel>> make_template_model(
    const std::string& name, const Cloud& cloud, const TemplateModelSettings& settings,
    const Progress& progress, const ForEach& for_each);

}  // namespace gripscan
