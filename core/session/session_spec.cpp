#include "core/session/session_spec.h"

#include <array>

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/session/yaml_parts.h"

namespace gripscan {
namespace {

constexpr std::array<std::string_view, 4> kKinds{"gripper", "object", "environment", "scene"};

SessionKind read_kind(StrictYaml& yaml) {
    const auto kind = yaml.text("kind");
    for (std::size_t i = 0; kind && i < kKinds.size(); ++i) {
        if (*kind == kKinds[i]) return static_cast<SessionKind>(i);
    }
    yaml.fail("kind",
              kind ? fmt::format("is '{}'; known are gripper, object, environment, scene", *kind)
                   : "is missing; known are gripper, object, environment, scene");
    return SessionKind::kGripper;
}

}  // namespace

TurnLimits turn_limits(const LimitsDeg& limits) {
    return {.angle_rad = rad_from_deg(limits.angle_deg),
            .sigmas = limits.sigmas,
            .overlap = limits.overlap,
            .slip_m = limits.slip_mm / kMmPerM,
            .tilt_rad = rad_from_deg(limits.tilt_deg)};
}

LimitsDeg limits_deg(const TurnLimits& limits) {
    return {.angle_deg = deg_from_rad(limits.angle_rad),
            .sigmas = limits.sigmas,
            .overlap = limits.overlap,
            .slip_mm = limits.slip_m * kMmPerM,
            .tilt_deg = deg_from_rad(limits.tilt_rad)};
}

std::string_view word(SessionKind kind) {
    return kKinds[static_cast<std::size_t>(kind)];
}

Result<SessionSpec> parse_session_spec(const std::filesystem::path& path, const std::string& text) {
    StrictYaml yaml = StrictYaml::parse(path, text);
    require_format(yaml, "gripscan-session/1");
    SessionSpec spec;
    spec.kind = read_kind(yaml);
    spec.step_deg = yaml.number("step_deg");
    if (spec.step_deg && (*spec.step_deg == 0.0 || std::abs(*spec.step_deg) > 180.0)) {
        yaml.fail("step_deg", "must not be 0 nor beyond 180");
    }
    spec.region = read_region(yaml);
    spec.axis_hint = read_axis_hint(yaml);
    spec.gripper_template = yaml.text("gripper_template");
    if (spec.gripper_template && spec.kind != SessionKind::kObject) {
        yaml.fail("gripper_template", "belongs to sessions of kind object only");
    }
    spec.limits = read_limits(yaml);
    yaml.reject_other_keys();
    if (Status status = yaml.status(); !status) return forward_error(status.error());
    return spec;
}

Result<SessionSpec> read_session_spec(const std::filesystem::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    return parse_session_spec(path, *text);
}

std::string session_spec_text(const SessionSpec& spec) {
    std::string text = "format: gripscan-session/1\n";
    text += fmt::format("kind: {}\n", word(spec.kind));
    if (spec.step_deg) text += fmt::format("step_deg: {}\n", text_from_number(*spec.step_deg));
    if (spec.region) text += region_line(*spec.region);
    if (spec.axis_hint) text += axis_hint_line(*spec.axis_hint);
    if (spec.gripper_template) {
        text += fmt::format("gripper_template: {}\n", yaml_quoted(*spec.gripper_template));
    }
    text += limits_line(spec.limits);
    return text;
}

}  // namespace gripscan
