// A step as it was judged while the turn goes on: the row of Table 1 and what the images said.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/registration/turn_report.h"

namespace gripscan {

/// Something in the registration area that was not there in the view before.
struct ForeignObject {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< camera frame
    double area_mm2 = 0.0;
};

struct JudgedStep {
    TurnStep row;  ///< from, to: indices of the captures
    std::optional<ForeignObject> foreign;
    std::vector<std::string> evidence;  ///< value against limit, the worst first
};

}  // namespace gripscan
