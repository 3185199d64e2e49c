// Pieces of the JSON documents. Includes nlohmann-json: for the sources of this folder only.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/geometry/pose.h"
#include "core/registration/turn_report.h"

namespace gripscan {

using Json = nlohmann::ordered_json;

/// Null where the number is unknown or not finite.
[[nodiscard]] Json json_number(const std::optional<double>& value);
/// In the unit of the files, see file_units.h.
[[nodiscard]] Json json_deg(const std::optional<double>& rad);
[[nodiscard]] Json json_mm(const std::optional<double>& metres);
[[nodiscard]] Json json_vector(const Eigen::Vector3d& v);
[[nodiscard]] Json json_pose(const std::optional<Pose>& T);
[[nodiscard]] Json json_limits(const TurnLimits& limits);
[[nodiscard]] Json json_closure(const TurnReport& report);
/// roll_deg, pitch_deg, yaw_deg, x_m, y_m, z_m of T, null without one.
void put_euler(Json& json, const std::optional<Pose>& T);

/// One line for each member, and for each item of an array that holds more than numbers.
[[nodiscard]] std::string document_text(const Json& json);

}  // namespace gripscan
