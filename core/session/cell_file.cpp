#include "core/session/cell_file.h"

#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/robot/joint6_limits.h"
#include "core/session/alignment_file.h"
#include "core/session/yaml_parts.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

constexpr int kLastPort = 65535;
constexpr double kMsPerS = 1000.0;

std::optional<int> read_port(StrictYaml& yaml, std::string_view key) {
    const auto number = yaml.number(key);
    if (!number) return std::nullopt;
    if (*number != std::floor(*number) || *number < 1 || *number > kLastPort) {
        yaml.fail(key, "must be a port from 1 to 65535");
        return std::nullopt;
    }
    return static_cast<int>(*number);
}

std::string read_needed(StrictYaml& yaml, std::string_view key) {
    auto text = yaml.text(key);
    if (!text) yaml.fail(key, "is missing");
    return text.value_or("");
}

std::optional<CellRobot> read_robot(StrictYaml& yaml) {
    auto map = yaml.map("robot");
    if (!map) return std::nullopt;
    CellRobot robot;
    const auto port = read_port(*map, "port");
    robot.port = port.value_or(robot.port);
    robot.monitor_port = read_port(*map, "monitor_port").value_or(robot.port + 1);
    robot.speed_percent = map->number("speed_percent").value_or(robot.speed_percent);
    if (!(robot.speed_percent >= kLeastSpeed_percent &&
          robot.speed_percent <= kMostSpeed_percent)) {
        map->fail("speed_percent",
                  fmt::format("must lie in {} to {}", kLeastSpeed_percent, kMostSpeed_percent));
    }
    const double settle_ms = map->number("settle_ms").value_or(robot.settle_s * kMsPerS);
    if (settle_ms < 0 || settle_ms > 60e3) map->fail("settle_ms", "must lie in 0 to 60000");
    robot.settle_s = settle_ms / kMsPerS;
    for (const auto* key : {"dialect", "host"}) (void)map->text(key);
    map->reject_other_keys();  // a misspelt key rather than the one that is missing for it
    robot.dialect = read_needed(*map, "dialect");
    robot.host = read_needed(*map, "host");
    if (robot.monitor_port == robot.port || robot.monitor_port > kLastPort) {
        map->fail("monitor_port", "must be another port than 'port', from 1 to 65535");
    }
    return robot;
}

std::optional<FrameServer> read_camera(StrictYaml& yaml) {
    auto map = yaml.map("camera");
    if (!map) return std::nullopt;
    const std::string driver = read_needed(*map, "driver");
    if (driver != "frames") {
        map->fail("driver", fmt::format("is '{}'; this version knows: frames", driver));
    }
    FrameServer server;
    server.port = read_port(*map, "port").value_or(server.port);
    (void)map->text("host");
    map->reject_other_keys();  // a misspelt key rather than the one that is missing for it
    server.host = read_needed(*map, "host");
    return server;
}

/// Relative to the cell file.
fs::path read_path(StrictYaml& yaml, std::string_view key, const fs::path& file) {
    const auto text = yaml.text(key);
    return text ? file.parent_path() / *text : fs::path();
}

/// The 16 numbers, or the file that `calibrate robot` wrote.
std::optional<Pose> read_alignment(StrictYaml& yaml, const fs::path& file) {
    if (!yaml.holds_text("alignment")) return read_pose(yaml, "alignment");
    const auto pose = load_standing_camera(read_path(yaml, "alignment", file));
    if (pose) return *pose;
    yaml.fail("alignment", "cannot be used: " + pose.error().message);
    return std::nullopt;
}

/// As it is written into `file`.
std::string path_line(std::string_view key, const fs::path& target, const fs::path& file) {
    const fs::path inside = target.lexically_relative(file.parent_path());
    const bool below = !inside.empty() && *inside.begin() != "..";
    std::error_code code;
    const fs::path written = below ? inside : fs::absolute(target, code);
    return fmt::format("{}: {}\n", key, yaml_quoted(written.string()));
}

std::string robot_line(const CellRobot& robot) {
    return fmt::format(
        "robot: {{dialect: {}, host: {}, port: {}, monitor_port: {}, speed_percent: {}, "
        "settle_ms: {}}}\n",
        yaml_quoted(robot.dialect), yaml_quoted(robot.host), robot.port, robot.monitor_port,
        text_from_number(robot.speed_percent), text_from_number(robot.settle_s * kMsPerS));
}

}  // namespace

Result<CellFile> load_cell_file(const fs::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    StrictYaml yaml = StrictYaml::parse(path, *text);
    require_format(yaml, "gripscan-cell/1");
    CellFile cell;
    cell.robot = read_robot(yaml);
    cell.camera = read_camera(yaml);
    cell.rig = read_path(yaml, "rig", path);
    cell.region = read_region(yaml);
    cell.axis_hint = read_axis_hint(yaml);
    cell.T_robot_camera = read_alignment(yaml, path);
    cell.limits = read_limits(yaml);
    cell.template_library = read_path(yaml, "template_library", path);
    yaml.reject_other_keys();
    if (Status status = yaml.status(); !status) return forward_error(status.error());
    return cell;
}

Status save_cell_file(const fs::path& path, const CellFile& cell) {
    std::string text = "format: gripscan-cell/1\n";
    if (cell.robot) text += robot_line(*cell.robot);
    if (cell.camera) {
        text += fmt::format("camera: {{driver: frames, host: {}, port: {}}}\n",
                            yaml_quoted(cell.camera->host), cell.camera->port);
    }
    if (!cell.rig.empty()) text += path_line("rig", cell.rig, path);
    if (cell.region) text += region_line(*cell.region);
    if (cell.axis_hint) text += axis_hint_line(*cell.axis_hint);
    if (cell.T_robot_camera) text += pose_line("alignment", *cell.T_robot_camera);
    text += limits_line(cell.limits);
    if (!cell.template_library.empty()) {
        text += path_line("template_library", cell.template_library, path);
    }
    return write_file_atomically(path, text);
}

}  // namespace gripscan
