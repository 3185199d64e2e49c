#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/console.h"
#include "core/concurrency/tcp_connection.h"
#include "core/robot/robot_conformance.h"

namespace gripscan::app {
namespace {

struct RobotCheckOptions {
    std::string host;
    unsigned monitor_port = 0;
    bool move = false;
};

/// "host", "host:port", "[v6]:port"; a v6 address without brackets has no port.
Result<std::pair<std::string, std::uint16_t>> host_and_port(const std::string& text) {
    const auto colon = text.rfind(':');
    const bool bracketed = text.starts_with('[');
    const auto closing = text.rfind(']');
    const bool closed = closing + 1 == text.size() || closing + 1 == colon;
    if (bracketed && (closing == std::string::npos || !closed)) {
        return input_error("'{}' is no address; give one of IPv6 as [ADDRESS] or [ADDRESS]:PORT",
                           text);
    }
    const bool has_port =
        colon != std::string::npos && (bracketed ? colon == closing + 1 : text.find(':') == colon);
    std::string host = has_port ? text.substr(0, colon) : text;
    if (bracketed && host.ends_with(']')) host = host.substr(1, host.size() - 2);
    std::uint16_t port = gsp::kMotionPort;
    if (has_port) {
        const char* first = text.data() + colon + 1;
        const char* last = text.data() + text.size();
        const auto [end, error] = std::from_chars(first, last, port);
        if (error != std::errc{} || end != last || port == 0) {
            return input_error("'{}' is no port; give HOST or HOST:PORT with 1 … 65535",
                               std::string(first, last));
        }
    }
    if (host.empty()) return input_error("'{}' names no host", text);
    return std::pair{host, port};
}

Result<gsp::ConformanceSettings> settings_of(const RobotCheckOptions& options) {
    const auto address = host_and_port(options.host);
    if (!address) return forward_error(address.error());
    gsp::ConformanceSettings settings;
    settings.host = address->first;
    settings.motion_port = address->second;
    settings.move = options.move;
    if (options.monitor_port == 0 && settings.motion_port == 65535) {
        return input_error("no port follows 65535; give --monitor-port");
    }
    settings.monitor_port = static_cast<std::uint16_t>(
        options.monitor_port != 0 ? options.monitor_port : settings.motion_port + 1u);
    return settings;
}

std::string line_of(const gsp::ConformanceCheck& check) {
    std::string line =
        fmt::format("{:<8} {:<16} {}", name_of(check.outcome), check.name, check.seen);
    if (check.outcome == gsp::CheckOutcome::kFailed)
        line += "\n         required: " + check.required;
    return line + "\n";
}

std::string json_of(const gsp::ConformanceSettings& settings,
                    const gsp::ConformanceReport& report) {
    nlohmann::ordered_json json{{"format", "gripscan-robot-check/1"}, {"dialect", "gsp1"}};
    json["host"] = settings.host;
    json["motion_port"] = settings.motion_port;
    json["monitor_port"] = settings.monitor_port;
    json["conforms"] = report.conforms();
    json["checks"] = nlohmann::ordered_json::array();
    for (const auto& check : report.checks) {
        json["checks"].push_back({{"name", check.name},
                                  {"outcome", name_of(check.outcome)},
                                  {"seen", check.seen},
                                  {"required", check.required}});
    }
    // What the controller sends may be any bytes.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Result<ExitStatus> robot_check(const RobotCheckOptions& options, const Context& context) {
    const auto settings = settings_of(options);
    if (!settings) return forward_error(settings.error());
    const bool as_text = !context.options.json && !context.options.quiet;
    const auto tell = [&](const gsp::ConformanceCheck& check) {
        if (as_text) print_result(line_of(check));
    };
    const auto report = gsp::check_conformance(*settings, tell, context.stop);
    if (!report) return forward_error(report.error());
    if (context.options.json) print_result(json_of(*settings, *report));
    const std::string place = place_of(settings->host, settings->motion_port);
    if (report->conforms()) {
        say(context, fmt::format("the controller at {} conforms to {}{}", place, gsp::kVersionText,
                                 options.move ? "" : ", as far as can be told without --move"));
        return kDone;
    }
    say(context,
        fmt::format("the controller at {} does not conform to {}; if another program talked to it "
                    "meanwhile, end that and check again",
                    place, gsp::kVersionText));
    return kNotTrusted;
}

}  // namespace

void add_robot_check(const CommandLine& line) {
    auto options = std::make_shared<RobotCheckOptions>();
    CLI::App* command = line.app.add_subcommand(
        "robot-check", "Does a controller, real or simulated, keep to the protocol?");
    command->add_option("host", options->host, "Where its server runs (port 18740)")
        ->required()
        ->option_text("HOST[:PORT]");
    command->add_option("--dialect", "Protocol (gsp1)")
        ->check(CLI::IsMember({"gsp1"}))
        ->option_text("gsp1");
    command
        ->add_option("--monitor-port", options->monitor_port,
                     "Port of the monitor connection (the one after PORT)")
        ->check(CLI::Range(1u, 65535u))
        ->option_text("PORT");
    command->add_flag("--move", options->move,
                      "Also turn joint 6, slowly and by 15 deg at most, and back");
    add_common_options(*command, line.common);
    command->footer(
        "One line a check. Without --move nothing moves. The controller has room for one client: "
        "no other program, a workstation or a run, may talk to it meanwhile. Exit status 0: it "
        "conforms, 1: it does not, 3: it cannot be reached.\n"
        "Example:\n  gripscan robot-check 192.168.0.10 --move");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return robot_check(*options, context); };
    });
}

}  // namespace gripscan::app
