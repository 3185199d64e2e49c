// Where shaders, fonts and themes lie at run time.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace gripscan::ui {

/// Folders that may hold `shaders/` and `assets/`, the first that exists wins: $GRIPSCAN_RESOURCES,
/// ../share/gripscan beside the program, the sources the program was built from.
[[nodiscard]] std::vector<std::filesystem::path> resource_folders();

/// A file by its path below such a folder, e.g. "shaders/points.vert". The error names every place
/// that was looked at.
[[nodiscard]] Result<std::filesystem::path> find_resource(std::string_view relative_path);

/// The whole file as text.
[[nodiscard]] Result<std::string> read_resource(std::string_view relative_path);

}  // namespace gripscan::ui
