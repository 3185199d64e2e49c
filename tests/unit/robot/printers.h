// Names for the parameters of the fault tests.
#pragma once

#include <string>

#include "tests/support/mock_controller.h"

namespace gripscan::gsp {

inline std::string name_of(test::Point point) {
    static constexpr std::array kNames{"Hello",        "Request",  "Accepted",
                                       "Moving",       "Done",     "MonitorRequest",
                                       "MonitorHello", "Question", "Stop"};
    return kNames.at(static_cast<std::size_t>(point));
}

inline std::string name_of(test::Mischief mischief) {
    static constexpr std::array kNames{"Drop",  "HalfOpen", "Never", "Late",   "Garbled",
                                       "Split", "Joined",   "Twice", "Babble", "Restart"};
    return kNames.at(static_cast<std::size_t>(mischief));
}

}  // namespace gripscan::gsp
