#include "core/sim/sim_cell_settings.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/sim/grippers.h"
#include "core/sim/objects.h"

namespace gripscan {

std::vector<std::string> sim_grippers() {
    return sim::gripper_names();
}
std::vector<std::string> sim_objects() {
    return sim::object_names();
}

namespace sim {
namespace {

Status check_motion(const SimCellSettings& settings) {
    if (!(settings.step_deg > 0.0 && settings.step_deg <= 180.0)) {
        return input_error("simulated cell: steps of {} deg; they must be above 0, at most 180",
                           settings.step_deg);
    }
    if (!(settings.time_scale > 0.0 && settings.time_scale <= 1e6)) {
        return input_error("simulated cell: time {} times as fast; it must be above 0, at most 1e6",
                           settings.time_scale);
    }
    const double start_deg = settings.start_joint6_deg.value_or(0.0);
    if (!(std::abs(start_deg) <= 360.0)) {
        return input_error("simulated cell: joint 6 cannot start at {} deg; it turns by +-360",
                           start_deg);
    }
    const unsigned fraction = settings.image_fraction;
    if (fraction < 1 || fraction > 8) {
        return input_error("simulated cell: images of 1/{} the size; it must be 1/1 ... 1/8",
                           fraction);
    }
    return {};
}

}  // namespace

Status check(const SimCellSettings& settings) {
    const auto known = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!known(sim_grippers(), settings.gripper)) {
        return input_error("simulated cell: no gripper is called '{}'; there are {}",
                           settings.gripper, fmt::join(sim_grippers(), ", "));
    }
    if (!settings.object.empty() && !known(sim_objects(), settings.object)) {
        return input_error("simulated cell: no object is called '{}'; there are {}",
                           settings.object, fmt::join(sim_objects(), ", "));
    }
    const auto in_range = [](double value, double limit) { return value >= 0.0 && value <= limit; };
    if (!in_range(settings.noise_levels, 50.0)) {
        return input_error("simulated cell: noise of {} levels; it must be 0 … 50",
                           settings.noise_levels);
    }
    if (!in_range(settings.blur_px, 20.0)) {
        return input_error("simulated cell: blur of {} px; it must be 0 … 20", settings.blur_px);
    }
    if (!in_range(settings.texture_contrast, 60.0)) {
        return input_error("simulated cell: texture contrast of {} levels; it must be 0 … 60",
                           settings.texture_contrast);
    }
    return check_motion(settings);
}

}  // namespace sim
}  // namespace gripscan
