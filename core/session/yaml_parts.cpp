#include "core/session/yaml_parts.h"

#include <algorithm>
#include <array>

#include "core/base/number_text.h"

namespace gripscan {
namespace {

constexpr double kLeastHint = 1e-9;
constexpr double kMostHint = 1e9;

void read_positive(StrictYaml& yaml, std::string_view key, double& value, double most) {
    const auto number = yaml.number(key);
    if (!number) return;
    if (*number <= 0.0 || *number > most) {
        yaml.fail(key, fmt::format("must be above 0 and at most {}", most));
        return;
    }
    value = *number;
}

std::string list(const Eigen::Vector3d& v) {
    return fmt::format("[{}, {}, {}]", text_from_number(v.x()), text_from_number(v.y()),
                       text_from_number(v.z()));
}

}  // namespace

void require_format(StrictYaml& yaml, std::string_view format) {
    const auto given = yaml.text("format");
    if (!given) {
        yaml.fail("format", fmt::format("is missing; expected 'format: {}'", format));
    } else if (*given != format) {
        yaml.fail("format", fmt::format("is '{}'; this version reads '{}'", *given, format));
    }
}

std::optional<Box> read_region(StrictYaml& yaml) {
    auto map = yaml.map("region");
    if (!map) return std::nullopt;
    const auto low = map->vector3("min");
    const auto high = map->vector3("max");
    map->reject_other_keys();
    if (!low || !high) {
        yaml.fail("region", "needs 'min' and 'max', each [x, y, z] in m");
        return std::nullopt;
    }
    const Box box{*low, *high};
    if (!box.valid()) {
        yaml.fail("region", "is empty: min must be below max in x, y and z");
        return std::nullopt;
    }
    return box;
}

std::optional<Eigen::Vector3d> read_axis_hint(StrictYaml& yaml) {
    const auto hint = yaml.vector3("axis_hint");
    if (!hint) return std::nullopt;
    // Beyond these the squares of the components leave the range of numbers, and no direction is
    // left.
    if (!(hint->norm() >= kLeastHint && hint->norm() <= kMostHint)) {
        yaml.fail("axis_hint", fmt::format("must be a direction, of a length from {} to {}",
                                           kLeastHint, kMostHint));
        return std::nullopt;
    }
    return hint->normalized();
}

LimitsDeg read_limits(StrictYaml& yaml) {
    LimitsDeg limits;
    auto map = yaml.map("limits");
    if (!map) return limits;
    read_positive(*map, "angle_deg", limits.angle_deg, 180.0);
    read_positive(*map, "sigmas", limits.sigmas, 1000.0);
    read_positive(*map, "overlap", limits.overlap, 1.0);
    read_positive(*map, "slip_mm", limits.slip_mm, 1e6);
    read_positive(*map, "tilt_deg", limits.tilt_deg, 180.0);
    map->reject_other_keys();
    return limits;
}

std::string region_line(const Box& region) {
    return fmt::format("region: {{min: {}, max: {}}}\n", list(region.min_m), list(region.max_m));
}

std::string axis_hint_line(const Eigen::Vector3d& axis_hint) {
    return fmt::format("axis_hint: {}\n", list(axis_hint));
}

std::string limits_line(const LimitsDeg& limits) {
    return fmt::format(
        "limits: {{angle_deg: {}, sigmas: {}, overlap: {}, slip_mm: {}, tilt_deg: {}}}\n",
        text_from_number(limits.angle_deg), text_from_number(limits.sigmas),
        text_from_number(limits.overlap), text_from_number(limits.slip_mm),
        text_from_number(limits.tilt_deg));
}

std::string yaml_quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20) {
            result += fmt::format("\\x{:02x}", static_cast<int>(c));
            continue;
        }
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

std::optional<Pose> read_pose(StrictYaml& yaml, std::string_view key) {
    const auto numbers = yaml.numbers(key, 16);
    if (!numbers) return std::nullopt;
    std::array<double, 16> matrix{};
    std::copy(numbers->begin(), numbers->end(), matrix.begin());
    auto pose = pose_from_row_major(matrix);
    if (!pose) yaml.fail(key, "is no rigid motion (4 x 4, row-major, m)");
    return pose;
}

std::string pose_line(std::string_view key, const Pose& T) {
    std::string numbers;
    for (const double number : row_major_from_pose(T)) {
        numbers += (numbers.empty() ? "" : ", ") + text_from_number(number);
    }
    return fmt::format("{}: [{}]\n", key, numbers);
}

}  // namespace gripscan
