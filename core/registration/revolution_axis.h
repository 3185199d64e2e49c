// The axis of a part that was turned on a lathe, from its normals alone.
#pragma once

#include <optional>
#include <span>

#include "core/geometry/axis.h"
#include "core/registration/surface.h"

namespace gripscan {

/// The line that the normals of all surfaces meet best: the normals of a surface of revolution lie
/// in a linear line complex, and its axis is the complex's (Pottmann and Randrup 1998). What does
/// not belong to the surface of revolution is held down by iterated reweighting. The sign of the
/// direction is arbitrary; the point is nearest to the surfaces' centre. Nothing if the surfaces
/// have no one axis (a sphere, a plane, no revolution at all).
[[nodiscard]] std::optional<Axis> revolution_axis(std::span<const Surface* const> surfaces);

}  // namespace gripscan
