// How far corresponding points lie from a common row. Features of the left image are looked for in
// a band of rows of the right one, so that it is found where matching along rows has failed
// already.
#pragma once

#include <stop_token>

#include "core/base/result.h"
#include "core/camera/stereo_source.h"
#include "core/stereo/search_area.h"

namespace gripscan {

struct RowErrorSettings {
    int half_patch_px = 7;
    int band_px = 6;           ///< rows above and below in which a feature is looked for
    int most_features = 240;   ///< the best ones; they bound the time
    int least_features = 12;   ///< fewer tell nothing
    double least_match = 0.8;  ///< normalised correlation
    double unique_by = 0.08;   ///< lead of the best place over any other
    double least_score = 8.0;  ///< of a feature: mean square of its weaker gradient, (levels/px)²
};

struct RowError {
    double median_px = 0.0;  ///< row in the right image minus row in the left one
    double sd_px = 0.0;      ///< of the median, from the scatter of the features
    int features = 0;
};

/// Errors: too little texture, features that are not found in the right image, cancelled.
[[nodiscard]] Result<RowError> measure_row_error(const StereoFrame& rectified,
                                                 const SearchArea& area,
                                                 const RowErrorSettings& settings,
                                                 const std::stop_token& stop);

}  // namespace gripscan
