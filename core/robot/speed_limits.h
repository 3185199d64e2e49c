// What joint 6 may be asked for, wherever it is asked: command line, cell file, plan, link.
#pragma once

namespace gripscan {

constexpr double kLeastSpeed_percent = 1.0;
constexpr double kMostSpeed_percent = 30.0;

}  // namespace gripscan
