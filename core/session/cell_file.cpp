#include "core/session/cell_file.h"

#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/session/yaml_parts.h"

namespace gripscan {
namespace {

std::optional<int> read_port(StrictYaml& yaml, std::string_view key) {
    const auto number = yaml.number(key);
    if (!number) return std::nullopt;
    if (*number != std::floor(*number) || *number < 1 || *number > 65535) {
        yaml.fail(key, "must be a port from 1 to 65535");
        return std::nullopt;
    }
    return static_cast<int>(*number);
}

std::optional<CellRobot> read_robot(StrictYaml& yaml) {
    auto map = yaml.map("robot");
    if (!map) return std::nullopt;
    CellRobot robot;
    robot.dialect = map->text("dialect").value_or("");
    if (robot.dialect.empty()) map->fail("dialect", "is missing");
    robot.host = map->text("host").value_or("");
    robot.port = read_port(*map, "port");
    robot.monitor_port = read_port(*map, "monitor_port");
    robot.speed_percent = map->number("speed_percent");
    if (robot.speed_percent && (*robot.speed_percent <= 0 || *robot.speed_percent > 100)) {
        map->fail("speed_percent", "must be above 0 and at most 100");
    }
    robot.settle_ms = map->number("settle_ms");
    if (robot.settle_ms && *robot.settle_ms < 0) map->fail("settle_ms", "must not be negative");
    map->reject_other_keys();
    return robot;
}

/// The rest of the camera's keys belong to its driver.
std::string read_camera_driver(StrictYaml& yaml) {
    auto map = yaml.map("camera");
    if (!map) return "";
    const auto driver = map->text("driver");
    if (!driver) map->fail("driver", "is missing");
    return driver.value_or("");
}

std::optional<Pose> read_alignment(StrictYaml& yaml) {
    const auto numbers = yaml.numbers("alignment", 16);
    if (!numbers) return std::nullopt;
    std::array<double, 16> matrix{};
    std::copy(numbers->begin(), numbers->end(), matrix.begin());
    auto pose = pose_from_row_major(matrix);
    if (!pose) yaml.fail("alignment", "is no rigid motion (4 x 4, row-major, m)");
    return pose;
}

}  // namespace

Result<CellFile> load_cell_file(const std::filesystem::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    StrictYaml yaml = StrictYaml::parse(path, *text);
    require_format(yaml, "gripscan-cell/1");
    CellFile cell;
    cell.robot = read_robot(yaml);
    cell.camera_driver = read_camera_driver(yaml);
    cell.rig = yaml.text("rig").value_or("");
    cell.region = read_region(yaml);
    cell.axis_hint = read_axis_hint(yaml);
    cell.T_robot_camera = read_alignment(yaml);
    cell.limits = read_limits(yaml);
    cell.template_library = yaml.text("template_library").value_or("");
    yaml.reject_other_keys();
    if (Status status = yaml.status(); !status) return forward_error(status.error());
    return cell;
}

}  // namespace gripscan
