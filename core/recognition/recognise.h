// Which templates are in a single view, and at which pose, without a starting guess.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/recognition/template_model.h"
#include "core/recognition/visible_agreement.h"

namespace gripscan {

struct RecogniseSettings {
    double least_score = 0.45;         ///< below it a template counts as absent
    double least_found = 0.15;         ///< share of the visible surface that must be found
    double alternative_margin = 0.06;  ///< other poses this close in score are named
    std::size_t most_per_template = 3;
};

/// A pose that fits the view nearly as well.
struct AlternativePose {
    Pose T_camera_template = Pose::Identity();
    double score = 0.0;
};

struct Detection {
    std::string name;  ///< of the template
    std::size_t template_index = 0;
    Pose T_camera_template = Pose::Identity();
    double score = 0.0;
    VisibleAgreement agreement;  ///< what the score is made of
    double rms_m = 0.0;          ///< of the points on the surface, along the normal
    double tied_down = 0.0;      ///< 0: some motion of the part would not be noticed
    double tolerance_m = 0.0;    ///< within which a point counts as on the surface
    std::string symmetry = "none";
    std::vector<AlternativePose> alternatives;
    std::vector<std::uint32_t> points;  ///< of the scene, that lie on the predicted surface

    /// The score in words.
    [[nodiscard]] std::string explained() const;
};

/// Best first; what is not in the scene is not listed. The frame of the scene is the camera's.
/// Errors: a scene with too few points, no templates; cancelled.
[[nodiscard]] Result<std::vector<Detection>> recognise(
    std::span<const std::shared_ptr<const TemplateModel>> models, const Cloud& scene,
    const RecogniseSettings& settings, const Progress& progress, const ForEach& for_each);

}  // namespace gripscan
