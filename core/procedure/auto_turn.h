// The automatic turn: read, expose, store, turn joint 6 by one step, until the part has come round.
#pragma once

#include "core/base/progress.h"
#include "core/camera/stereo_source.h"
#include "core/procedure/journal.h"
#include "core/robot/robot_link.h"

namespace gripscan {

struct TakenCapture {
    int index = 0;
    double commanded_rad = 0.0;  ///< turn since the first capture
    RobotReading before;         ///< read before the exposure
    RobotReading after;          ///< read after it
    StereoFrame frame;
};

/// Keeps captures as they are made.
class TurnStore {
  public:
    virtual ~TurnStore() = default;
    [[nodiscard]] virtual Status store(const TakenCapture& capture) = 0;
};

struct AutoTurnSettings {
    double step_rad = 0.17453292519943295;
    double start_joint6_rad = 0.0;
    double joint6_limit_rad = 6.283185307179586;  ///< joint 6 turns within ± this
};

/// Steps of a whole turn: 360° / step, rounded. step > 0.
[[nodiscard]] int steps_of_turn(double step_rad);

/// Takes steps_of_turn() + 1 captures, the last one closing the turn, at absolute joint angles so
/// that errors do not add up. Errors: a turn beyond the joint's range, the device, cancelled.
[[nodiscard]] Status take_turn(RobotLink& robot, StereoSource& source,
                               const AutoTurnSettings& settings, TurnStore& store,
                               Journal& journal, const Progress& progress);

}  // namespace gripscan
