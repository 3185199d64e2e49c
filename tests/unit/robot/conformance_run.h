// The conformance script against a controller of the tests, and its report in short.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/robot/robot_conformance.h"
#include "tests/support/mock_controller.h"

namespace gripscan::gsp {

inline ConformanceSettings settings_of(const test::MockController& controller, bool move) {
    ConformanceSettings settings;
    settings.motion_port = controller.motion_port();
    settings.monitor_port = controller.monitor_port();
    settings.move = move;
    settings.reply_limit = std::chrono::milliseconds(1500);
    settings.motion_limit = std::chrono::milliseconds(5000);
    settings.split_pause = std::chrono::milliseconds(10);
    return settings;
}

inline ConformanceReport report_of(test::MockController& controller, bool move) {
    controller.turns_for(std::chrono::milliseconds(250));
    auto report = check_conformance(settings_of(controller, move), {}, {});
    EXPECT_TRUE(report);
    return report ? *report : ConformanceReport{};
}

inline std::vector<std::string> names(const ConformanceReport& report, CheckOutcome outcome) {
    std::vector<std::string> result;
    for (const auto& check : report.checks) {
        if (check.outcome == outcome) result.push_back(check.name);
    }
    return result;
}

inline std::string failures(const ConformanceReport& report) {
    std::string text;
    for (const auto& check : report.checks) {
        if (check.outcome != CheckOutcome::kFailed) continue;
        text += fmt::format("{}: {} (required: {})\n", check.name, check.seen, check.required);
    }
    return text;
}

}  // namespace gripscan::gsp
