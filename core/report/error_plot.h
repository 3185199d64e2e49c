// The error of every step as an SVG drawing: points by verdict, the predicted band, the limit.
#pragma once

#include <string>

#include "core/registration/turn_report.h"

namespace gripscan {

/// An <svg> element for use inside a page; it takes its colours from the page's CSS variables.
/// Errors far beyond the limit are drawn at the edge with their value, so that the rest stays
/// readable. Empty text if no step has an error.
[[nodiscard]] std::string error_plot_svg(const TurnReport& report);

}  // namespace gripscan
