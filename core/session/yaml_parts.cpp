#include "core/session/yaml_parts.h"

namespace gripscan {
namespace {

void read_positive(StrictYaml& yaml, std::string_view key, double& value, double most) {
    const auto number = yaml.number(key);
    if (!number) return;
    if (*number <= 0.0 || *number > most) {
        yaml.fail(key, fmt::format("must be above 0 and at most {}", most));
        return;
    }
    value = *number;
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
    if (hint->norm() < 1e-9) {
        yaml.fail("axis_hint", "must be a direction, not zero");
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

}  // namespace gripscan
