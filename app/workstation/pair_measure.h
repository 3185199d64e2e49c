// What only a matched pair tells of live images: the share of the registration area that stereo can
// fill, and how far the images' rows are apart. Takes some tenths of a second: for a worker's
// thread.
#pragma once

#include <memory>
#include <optional>

#include "core/base/progress.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "ui/views/snapshot.h"

namespace gripscan::app {

struct MeasuredPair {
    /// The same images, with their disparity.
    std::shared_ptr<const ui::StereoPicture> picture;
    ui::PairFacts facts;
};

/// The disparity is made at half the resolution, by the functions that captures go through; the row
/// error from features at full resolution. What cannot be measured is left out with the reason.
/// Errors: cancelled.
[[nodiscard]] Result<MeasuredPair> measure_pair(const ui::StereoPicture& rectified,
                                                const RectifiedRig& rig,
                                                const std::optional<Box>& region,
                                                const std::stop_token& stop);

}  // namespace gripscan::app
