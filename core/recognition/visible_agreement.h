// Does a view show what it should, if the template were there? Counted over the surface that the
// camera would see.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/pose.h"
#include "core/recognition/scene_view.h"
#include "core/recognition/template_model.h"

namespace gripscan {

/// How much what speaks against a pose counts, in cells that speak for it. Where an edge lies and
/// what is measured beside it is known of our own stereo, by many views of it; another camera's
/// depth, or a laser's, only says whether a surface ends near there at all.
struct AgreementWeights {
    double contradicts;  ///< a measurement behind the part
    double mismatches;   ///< another surface close by: what is held, or touches, is seen there too
    double unknown;      ///< nothing measured: stereo leaves holes
    double open;         ///< share of an end that is worth beyond which nothing is measured
    double bends;        ///< a surface that adjoins: parts are held, and lie on tables
    double strays;       ///< an edge that is not where the others are
    double goes_on;      ///< no edge: where a part is, hardly any
    double support_power;
    double outline_power;
    double found_power;
    double least_outline;  ///< of a part that is there
};
[[nodiscard]] const AgreementWeights& weights_for(const SceneView& scene);

/// Cells of the map (rough_agreement: points) in which the part would be seen if nothing stood
/// before it. Cells beside an edge are left out: stereo moves edges.
struct VisibleAgreement {
    const AgreementWeights* weights = nullptr;  ///< static; null: nothing was judged
    int visible = 0;
    int seen = 0;          ///< measured on the predicted surface, and it looks the same way
    int hidden = 0;        ///< something stands well in front, which says nothing
    int contradicted = 0;  ///< the camera looks through where the part should be
    int mismatched = 0;    ///< measured close by: another surface, or one that looks another way
    int unknown = 0;       ///< nothing measured
    /// Of the predicted outline where the part was found inside it. An outline hides what is behind
    /// it, so the depth jumps there, or nothing is measured.
    int outline_ends = 0;     ///< what is measured beyond lies well behind
    int outline_open = 0;     ///< nothing is measured beyond
    int outline_bends = 0;    ///< a surface at the same depth adjoins: perhaps a thing that touches
    int outline_strays = 0;   ///< an edge is near, but not where the others say
    int outline_goes_on = 0;  ///< the surface goes on as if the part had no edge

    /// Of what could be judged, the share that agrees; what speaks against the part counts more
    /// than what merely was not measured.
    [[nodiscard]] double support() const;
    /// Share of the whole visible surface that was found.
    [[nodiscard]] double found() const;
    /// Share of the outline that the scene shows.
    [[nodiscard]] double outline() const;
    /// What poses are ranked and judged by, in [0, 1].
    [[nodiscard]] double score() const;
    /// The shares above as one line.
    [[nodiscard]] std::string terms() const;
};

/// Roughly, for very many poses: coarse points, without the outline.
[[nodiscard]] VisibleAgreement rough_agreement(const TemplateModel& model, const SceneView& scene,
                                               const Pose& T_scene_template, double tolerance_m);

/// With all samples and the outline. `claimed` (may be null) receives the scene points that lie on
/// the predicted surface.
[[nodiscard]] VisibleAgreement full_agreement(const TemplateModel& model, const SceneView& scene,
                                              const Pose& T_scene_template, double tolerance_m,
                                              std::vector<std::uint32_t>* claimed);

/// Two poses in which the part looks nearly the same, judged by what they tell differently: cells
/// where one of them is right and the other is not.
struct Duel {
    int first = 0;   ///< cells that speak for the first
    int second = 0;  ///< for the second
    /// Whether so many more speak for one that it is no chance: neighbouring cells err together.
    [[nodiscard]] bool decisive() const;
};
[[nodiscard]] Duel duel(const TemplateModel& model, const SceneView& scene, const Pose& T_first,
                        const Pose& T_second, double tolerance_m);

}  // namespace gripscan
