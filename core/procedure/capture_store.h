// Where captures are kept: on the disk before anything is done with them, and read back from there.
#pragma once

#include <span>
#include <vector>

#include "core/camera/stereo_source.h"
#include "core/procedure/capture_record.h"
#include "core/procedure/turn_plan.h"
#include "core/procedure/turn_recording.h"

namespace gripscan {

/// Writing returns once everything is safe, and replaces nothing half: a crash leaves the state
/// before or after.
class CaptureStore {
  public:
    virtual ~CaptureStore() = default;
    /// The images of an attempt at capture `index`. Written again (after a crash between images and
    /// table) they replace those of the same attempt.
    [[nodiscard]] virtual Status store_images(int index, int attempt, const StereoFrame& frame) = 0;
    /// The whole table, in order of the indices; every capture in it has its images stored.
    [[nodiscard]] virtual Status save_table(std::span<const CaptureRecord> captures) = 0;
    /// Step and limits, by which a reader of the recording will judge it.
    [[nodiscard]] virtual Status save_plan(const TurnPlan& plan) = 0;
    /// The captures as the pipeline takes them, exactly as a reader of the saved table would.
    [[nodiscard]] virtual std::vector<RecordedCapture> recorded(
        std::span<const CaptureRecord> captures) const = 0;
};

}  // namespace gripscan
