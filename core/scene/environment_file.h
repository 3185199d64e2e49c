// environment.bin: a learned environment on the disk (docs/environment-file.md).
#pragma once

#include <filesystem>

#include "core/scene/environment_model.h"

namespace gripscan {

/// What is loaded equals what was saved, bit for bit.
[[nodiscard]] Status save_environment(const std::filesystem::path& path,
                                      const EnvironmentModel& model);

/// A file, or a session folder of kind environment with `results/environment.bin`. Errors: absent,
/// no such file, another version, damaged (the checksum tells).
[[nodiscard]] Result<EnvironmentModel> load_environment(const std::filesystem::path& path);

}  // namespace gripscan
