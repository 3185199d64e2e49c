// A value of every step against its limits, with the band of its expected error: the error plot
// beside Table 1, and sparklines.
#pragma once

#include <span>

#include "ui/widgets/state_shape.h"

namespace gripscan::ui {

struct PlotPoint {
    double value = 0.0;  ///< no number: nothing is drawn there
    double sigma = 0.0;  ///< 0: no band
    State state = State::kAccept;
};

struct ErrorPlot {
    std::span<const PlotPoint> points;  ///< of steps 1, 2, …
    std::size_t steps = 0;              ///< of the whole turn; later ones are shaded
    double limit = 0.0;                 ///< dashed at ± limit
    int decimals = 1;                   ///< of the axis
    std::size_t selected = 0;           ///< step with the large point, from 1; 0: the last
};

/// Index (from 0) of the point that was clicked; `steps` of the plot if none was.
[[nodiscard]] std::size_t error_plot(const Ui& ui, const Rect& rect, std::string_view id,
                                     const ErrorPlot& plot);

/// The line alone, without axes, in the height of a table row.
void draw_sparkline(const Ui& ui, const Rect& rect, std::span<const PlotPoint> points,
                    double limit);

/// Half the range of the value axis: a little more than the limit.
[[nodiscard]] double plot_half_range(const ErrorPlot& plot);

}  // namespace gripscan::ui
