// Motions after which a part looks as before, or nearly so: found by laying the part onto itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/for_each.h"
#include "core/geometry/axis.h"

namespace gripscan {

struct TemplateModel;

struct Symmetry {
    std::string name = "none";  ///< "none", "revolution", "2-fold", "6-fold", "4 turns", …
    /// Turns (other than none) after which the part is the same; without those of a revolution.
    std::vector<Pose> turns;
    /// The part is the same after every turn about this line.
    std::optional<Axis> revolution;
    /// Turns after which most of the part, but not all of it, is the same: what a view that hides
    /// the difference cannot tell apart.
    std::vector<Pose> near_turns;
};

[[nodiscard]] Symmetry find_symmetry(const TemplateModel& model, const ForEach& for_each);

/// The pose, of all that look the same, that lies nearest to `reference`.
[[nodiscard]] Pose nearest_equivalent(const Pose& T, const Symmetry& symmetry,
                                      const Pose& reference);

}  // namespace gripscan
