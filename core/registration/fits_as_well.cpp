#include "core/registration/fits_as_well.h"

#include "core/registration/align_surfaces.h"
#include "core/registration/texture_difference.h"
#include "core/registration/texture_rows.h"

namespace gripscan {
namespace {

/// Surfaces fit as well if they miss each other by no more than this factor and share no less than
/// this of their points: the other motion, a gripper's, is known to a tenth of a millimetre, under
/// half the noise of a point, which adds a tenth.
constexpr double kAsClose = 1.15;
constexpr double kAsMuch = 0.05;
/// And their patterns, at the coarse scale where that tenth of a millimetre changes little.
constexpr double kAsAlike = 1.25;
constexpr int kCoarseTexture = kTextureScales - 1;

}  // namespace

bool fits_as_well(const Surface& source, const Surface& target, const Alignment& answer,
                  const Pose& T_other, const AlignSettings& settings) {
    const Alignment other = alignment_at(source, target, T_other, settings);
    if (other.misfit > kAsClose * answer.misfit || other.overlap < answer.overlap - kAsMuch) {
        return false;
    }
    const auto there = texture_difference(source, target, other, kCoarseTexture);
    const auto here = texture_difference(source, target, answer, kCoarseTexture);
    return !here || (there && *there <= kAsAlike * *here);
}

}  // namespace gripscan
