// The table below the stereo images: what was measured in the registration area, against its limit.
// And what the images show of it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

enum class FactState { kNone, kGood, kWarning, kBad };

struct StereoFact {
    std::string label;  ///< "Fill %"
    std::string left;   ///< "93"; empty: unknown
    std::string right;  ///< empty: of the pair, or unknown
    std::string limit;  ///< "≥ 10"; empty: none
    FactState state = FactState::kNone;
    std::string tooltip;  ///< what it is and why it has this limit
};

/// The images that are shown: the live ones, else those of the selected step.
struct ShownPicture {
    std::shared_ptr<const StereoPicture> picture;  ///< null: there is none
    bool live = false;
    std::string title;  ///< "live", "capture 14"
    std::string why_not_live;
    bool has_disparity = false;  ///< it can be shown with its disparity
};
/// `with_disparity`: of the live pairs the one that was matched last.
[[nodiscard]] ShownPicture shown_picture(const Snapshot& snapshot, bool with_disparity = false);

/// Fill and row error of what is shown. Live pairs have those of the pair matched last, while that
/// is not long ago; a number that is missing has its reason.
[[nodiscard]] PairFacts pair_facts(const Snapshot& snapshot, const ShownPicture& shown);

[[nodiscard]] std::vector<StereoFact> stereo_facts(const Snapshot& snapshot,
                                                   const ShownPicture& shown);

/// The outline of the registration area in an image, px: the convex hull of its corners. Empty
/// where it is not wholly in front of the camera.
enum class Eye { kLeft, kRight };
[[nodiscard]] std::vector<Eigen::Vector2d> area_outline_px(const CellFrame& cell, Eye eye);

/// Disparities at the ends of the legend: those of the area's depths where it is known, else of
/// what the image holds.
struct DisparityRange {
    double far_px = 0.0;
    double near_px = 1.0;
    std::string far_mm;  ///< depths for the legend; px where the rig is unknown
    std::string near_mm;
};
[[nodiscard]] DisparityRange disparity_range(const StereoPicture& picture, const CellFrame& cell);

/// "row 512  Δy 0.08 px"
[[nodiscard]] std::string row_text(int row, const std::optional<double>& row_error_px);
/// "412, 300: 187": pixel and level; of disparity "412, 300: 98.20 px, 702.1 mm".
[[nodiscard]] std::string level_text(const cv::Mat& grey, int x, int y);
[[nodiscard]] std::string disparity_text(const StereoPicture& picture, const CellFrame& cell, int x,
                                         int y);

}  // namespace gripscan::ui
