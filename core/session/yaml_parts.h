// The parts that session.yaml and a cell file share. For the sources of this folder only.
#pragma once

#include "core/geometry/pose.h"
#include "core/session/session_spec.h"
#include "core/session/strict_yaml.h"

namespace gripscan {

/// `format: NAME` must be there and be this one.
void require_format(StrictYaml& yaml, std::string_view format);
[[nodiscard]] std::optional<Box> read_region(StrictYaml& yaml);
[[nodiscard]] std::optional<Eigen::Vector3d> read_axis_hint(StrictYaml& yaml);
[[nodiscard]] LimitsDeg read_limits(StrictYaml& yaml);
/// 16 numbers, row-major; an error if they are no rigid motion.
[[nodiscard]] std::optional<Pose> read_pose(StrictYaml& yaml, std::string_view key);

// The same as lines of a file.
[[nodiscard]] std::string region_line(const Box& region);
[[nodiscard]] std::string axis_hint_line(const Eigen::Vector3d& axis_hint);
[[nodiscard]] std::string limits_line(const LimitsDeg& limits);
[[nodiscard]] std::string pose_line(std::string_view key, const Pose& T);
/// A double-quoted scalar that reads back as the text.
[[nodiscard]] std::string yaml_quoted(const std::string& text);

}  // namespace gripscan
