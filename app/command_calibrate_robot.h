// `calibrate robot`: where the camera stands relative to the robot.
#pragma once

#include "app/commands.h"

namespace gripscan::app {

void add_calibrate_robot(CLI::App& calibrate, const CommandLine& line);

}  // namespace gripscan::app
