// How good a template is: how far its points lie from the true surface, and how much of what the
// camera could see it covers.
#pragma once

#include "core/cloud/cloud.h"
#include "tests/tools/truth_files.h"

namespace gripscan::test {

struct TemplateScore {
    std::size_t points = 0;
    double rms_mm = 0.0;  ///< of all points, none left out
    double p50_mm = 0.0;
    double p90_mm = 0.0;
    double p99_mm = 0.0;
    double max_mm = 0.0;
    double coverage = 0.0;  ///< share of the visible samples with a point within 1 mm
    /// Of an object: share of the points that are not its own: nearer to what holds it than to it, or
    /// more than 2 mm off its surface.
    double foreign = 0.0;
};

/// `T_first_template`: from the template's frame into the camera frame of the first true capture.
[[nodiscard]] TemplateScore score_template(const Cloud& points, const Pose& T_first_template,
                                           const Truth& truth);

}  // namespace gripscan::test
