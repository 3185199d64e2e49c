// The registration area in a cell file that people have written: everything else stays as it is,
// comments too.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/geometry/box.h"

namespace gripscan::app {

/// The text of the file with that area in the place of its own, at the end where it has none.
[[nodiscard]] std::string with_region(std::string_view cell_file, const Box& region);

/// Errors, after which the file is as it was: it cannot be read or written, or does not read back
/// with that area.
[[nodiscard]] Status keep_region(const std::filesystem::path& cell_file, const Box& region);

}  // namespace gripscan::app
