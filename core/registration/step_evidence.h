// What is known about a step beside its row: what the two views say of each other, of the camera,
// of the robot's joints, of the images.
#pragma once

#include <optional>
#include <string>

#include "core/registration/image_health.h"
#include "core/registration/unexplained.h"
#include "core/registration/verdict.h"
#include "core/registration/visibility.h"

namespace gripscan {

/// Motion of the still background between two captures.
struct CameraShift {
    double shift_px = 0.0;  ///< median over the patches, their noise taken off
    double noise_px = 0.0;  ///< of one patch
    double agreeing = 0.0;  ///< share of the patches that moved, or stood, with the median
    int patches = 0;        ///< found again
};

struct StepEvidence {
    bool found = false;
    Cause cause_not_found = Cause::kNotConverged;
    std::string why_not_found;  ///< empty: nothing more is known
    bool starts_agree = true;
    double least_observability = 0.0;
    double joint6_moved_rad = 0.0;        ///< between the readings before and after an exposure
    double other_joints_moved_rad = 0.0;  ///< largest change of J1 … J5
    bool paper_icp = false;               ///< no uncertainty, no observability
    std::optional<double> misfit;  ///< axis-locked: residuals against the noise, 1 = as expected
    /// What the views share if the part turned as the robot says, however that was aligned.
    std::optional<Agreement> as_reported;
    std::optional<CameraShift> camera_shift;
    /// What one view shows and the other should have seen.
    std::optional<Unexplained> unexplained;
    int unexplained_in = 0;             ///< capture that shows it
    double unexplained_limit_m2 = 0.0;  ///< of its area
    std::optional<ImageFault> image_fault;
    int image_fault_in = 0;       ///< capture with the poorer images
    bool foreign_object = false;  ///< set by the diagnosis: something stands in the area
};

}  // namespace gripscan
