// Where the controller is, what it may be asked for, and how long it may take.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/robot/gsp_message.h"
#include "core/robot/joint6_limits.h"

namespace gripscan::gsp {

struct GspSettings {
    std::string host = "127.0.0.1";
    std::uint16_t motion_port = kMotionPort;
    std::uint16_t monitor_port = 0;        ///< 0: the one after the motion port
    bool motion_rights = true;             ///< false: the motion port is left alone, turns refused
    std::string model = "LRMate200iC/5L";  ///< as HELLO tells it; empty: any of six axes

    double max_step_deg = kMostTurn_deg;  ///< from where joint 6 stands
    double max_speed_percent = kMostSpeed_percent;
    double joint6_speed_deg_s = 720.0;   ///< at 100 %
    double target_tolerance_deg = 0.05;  ///< of joint 6
    double other_joint_tolerance_deg = 0.02;

    std::chrono::milliseconds connect_limit{3000};
    std::chrono::milliseconds reply_limit{2000};  ///< to any request, and until a turn is accepted
    std::chrono::milliseconds done_margin{5000};  ///< beyond angle / speed
    std::chrono::milliseconds retry_pause{200};   ///< between two attempts to connect
    std::chrono::milliseconds beat_period{1000};
    std::chrono::milliseconds beat_period_moving{200};
    int max_recoveries = 3;  ///< of one turn

    [[nodiscard]] std::uint16_t port_of_monitor() const {
        return monitor_port != 0 ? monitor_port : static_cast<std::uint16_t>(motion_port + 1);
    }
};

}  // namespace gripscan::gsp
