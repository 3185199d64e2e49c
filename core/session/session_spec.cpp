#include "core/session/session_spec.h"

#include <array>

#include "core/base/number_text.h"
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

std::string list(const Eigen::Vector3d& v) {
    return fmt::format("[{}, {}, {}]", text_from_number(v.x()), text_from_number(v.y()),
                       text_from_number(v.z()));
}

/// A path as a YAML double-quoted scalar: only backslash and quote need care.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

}  // namespace

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

std::string session_spec_text(const SessionSpec& spec) {
    std::string text = "format: gripscan-session/1\n";
    text += fmt::format("kind: {}\n", word(spec.kind));
    if (spec.step_deg) text += fmt::format("step_deg: {}\n", text_from_number(*spec.step_deg));
    if (spec.region) {
        text += fmt::format("region: {{min: {}, max: {}}}\n", list(spec.region->min_m),
                            list(spec.region->max_m));
    }
    if (spec.axis_hint) text += fmt::format("axis_hint: {}\n", list(*spec.axis_hint));
    if (spec.gripper_template) {
        text += fmt::format("gripper_template: {}\n", quoted(*spec.gripper_template));
    }
    const LimitsDeg& limits = spec.limits;
    text += fmt::format(
        "limits: {{angle_deg: {}, sigmas: {}, overlap: {}, slip_mm: {}, tilt_deg: {}}}\n",
        text_from_number(limits.angle_deg), text_from_number(limits.sigmas),
        text_from_number(limits.overlap), text_from_number(limits.slip_mm),
        text_from_number(limits.tilt_deg));
    return text;
}

}  // namespace gripscan
