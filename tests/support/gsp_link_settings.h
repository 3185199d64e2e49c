// A link to a controller of the tests, with little patience, so that what never comes is soon
// missed.
#pragma once

#include "core/robot/gsp_link.h"
#include "tests/support/mock_controller.h"

namespace gripscan::test {

inline gsp::GspSettings quick_settings(const MockController& controller) {
    using std::chrono::milliseconds;
    gsp::GspSettings settings;
    settings.motion_port = controller.motion_port();
    settings.monitor_port = controller.monitor_port();
    settings.joint6_speed_deg_s = 7200.0;
    settings.connect_limit = milliseconds(1000);
    settings.reply_limit = milliseconds(400);
    settings.done_margin = milliseconds(300);
    settings.retry_pause = milliseconds(10);
    settings.beat_period = milliseconds(50);
    settings.beat_period_moving = milliseconds(10);
    return settings;
}

}  // namespace gripscan::test
