#include "app/manual_prompt.h"

#include <poll.h>
#include <unistd.h>

#include <iostream>

#include "core/base/number_text.h"
#include "core/base/units.h"

namespace gripscan::app {
namespace {

/// One line of standard input, read unbuffered, so that waiting for it can be ended.
Result<std::string> read_line(std::stop_token stop) {
    std::string line;
    while (!stop.stop_requested()) {
        pollfd input{STDIN_FILENO, POLLIN, 0};
        if (::poll(&input, 1, 100) <= 0) continue;
        char c = 0;
        const ssize_t got = ::read(STDIN_FILENO, &c, 1);
        if (got <= 0) {
            return input_error(
                "standard input has ended while the operator was asked to turn joint 6; what was "
                "recorded is kept, go on with --resume");
        }
        if (c == '\n') return line;
        line += c;
    }
    return cancelled_error();
}

}  // namespace

Result<Command> prompt_for_angle(const std::optional<double>& target_rad, bool readable,
                                 std::stop_token stop) {
    const std::string what =
        target_rad ? fmt::format("turn joint 6 to {:.2f} deg, then", deg_from_rad(*target_rad))
                   : "to begin with,";
    for (;;) {
        std::cerr << fmt::format(
            "{} {}: ", what,
            readable ? "press Enter" : "type the angle joint 6 shows, in deg, and press Enter");
        auto line = read_line(stop);
        if (!line) return forward_error(line.error());
        if (line->empty() && readable) return Command{command::Capture{}};
        if (readable) {
            std::cerr << "the robot tells its angle; just press Enter\n";
            continue;
        }
        if (const auto angle_deg = number_from_text(*line)) {
            return Command{command::TellAngle{rad_from_deg(*angle_deg)}};
        }
        std::cerr << "'" << *line << "' is no angle\n";
    }
}

}  // namespace gripscan::app
