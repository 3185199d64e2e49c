// One exposure of a standing arm: settle, look twice whether it stands, read the joints around it.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "core/camera/stereo_source.h"
#include "core/procedure/capture_record.h"
#include "core/procedure/shot.h"
#include "core/robot/robot_link.h"

namespace gripscan {

struct ExposureSettings {
    double settle_s = 0.3;  ///< from the robot's confirmation to the first exposure
    int tries = 5;          ///< pairs of exposures until two agree
    double pause_s = 0.2;   ///< between them
};

/// Why two exposures do not show a standing scene; nothing: they agree.
using StillnessTest =
    std::function<std::optional<std::string>(const StereoFrame& first, const StereoFrame& second)>;

struct Exposure {
    StereoFrame frame;
    std::optional<RobotReading> before;  ///< nothing where no robot is read
    std::optional<double> joint6_after_rad;
};

/// `robot` may be null. Errors: robot or camera failed, the scene does not come to rest (the
/// message says what moved), cancelled.
[[nodiscard]] Result<Exposure> expose(RobotLink* robot, StereoSource& source, const Shot& shot,
                                      const StillnessTest& differs,
                                      const ExposureSettings& settings, std::stop_token stop);

/// What the table of captures keeps of it.
[[nodiscard]] CaptureRecord record_of(const Shot& shot, const Exposure& exposure);

/// Waits, unless stopped before; false: stopped.
[[nodiscard]] bool wait_for(double seconds, std::stop_token stop);

}  // namespace gripscan
