// Where captures are kept: on the disk before anything is done with them.
#pragma once

#include <span>

#include "core/camera/stereo_source.h"
#include "core/procedure/capture_record.h"

namespace gripscan {

/// Both calls return once everything is safe. What is written replaces nothing half: a crash leaves
/// the state before or after.
class CaptureStore {
  public:
    virtual ~CaptureStore() = default;
    /// The images of capture `index`. Written again (after a crash between images and table) they
    /// replace the ones of the same index.
    [[nodiscard]] virtual Status store_images(int index, const StereoFrame& frame) = 0;
    /// The whole table, in order of the indices; every capture in it has its images stored.
    [[nodiscard]] virtual Status save_table(std::span<const CaptureRecord> captures) = 0;
};

}  // namespace gripscan
