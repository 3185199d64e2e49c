// Does a view show what it should, if the template were there? Counted over the surface that the
// camera would see.
#pragma once

#include <vector>

#include "core/geometry/pose.h"
#include "core/recognition/scene_view.h"
#include "core/recognition/template_model.h"

namespace gripscan {

/// Samples of the template that the camera would see if nothing stood before it.
struct VisibleAgreement {
    int visible = 0;
    int seen = 0;          ///< measured on the predicted surface, and it looks the same way
    int hidden = 0;        ///< something stands in front
    int contradicted = 0;  ///< the camera looks through where the part should be
    int mismatched = 0;    ///< measured there, but the surface looks another way
    int unknown = 0;       ///< nothing measured
    /// Of the predicted outline: places where the scene ends or bends there, and places where its
    /// surface goes on as if the part had no edge.
    int outline_ends = 0;
    int outline_goes_on = 0;
    int outline_open = 0;  ///< places where nothing is measured beyond: the scene may end there

    /// Of what could be judged, the share that agrees.
    [[nodiscard]] double support() const;
    /// Share of the whole visible surface that was found.
    [[nodiscard]] double found() const;
    /// Share of the outline that the scene shows.
    [[nodiscard]] double outline() const;
    /// What poses are ranked and judged by, in [0, 1]: found surface times what speaks against it.
    [[nodiscard]] double score() const;
};

/// Roughly, for very many poses: coarse points, without the outline.
[[nodiscard]] VisibleAgreement rough_agreement(const TemplateModel& model, const SceneView& scene,
                                               const Pose& T_scene_template, double tolerance_m);

/// With all samples and the outline. `claimed` (may be null) receives the scene points that lie on
/// the predicted surface.
[[nodiscard]] VisibleAgreement full_agreement(const TemplateModel& model, const SceneView& scene,
                                              const Pose& T_scene_template, double tolerance_m,
                                              std::vector<std::uint32_t>* claimed);

}  // namespace gripscan
