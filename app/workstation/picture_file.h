// Pictures of the window as files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/base/result.h"

namespace gripscan::app {

/// PNG from RGBA rows, top to bottom. The file appears whole.
[[nodiscard]] Status save_png(const std::filesystem::path& file, int width_px, int height_px,
                              std::span<const std::uint8_t> rgba);

}  // namespace gripscan::app
