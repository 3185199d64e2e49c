// Files appear whole or not at all: written beside, synced to the disk, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace gripscan {

/// Replaces `path` by `content`. On failure the old file is untouched and nothing is left behind;
/// only where the folder itself cannot be synced, the new one lies there and the message says so.
[[nodiscard]] Status write_file_atomically(const std::filesystem::path& path,
                                           std::string_view content);

/// The same for a writer that wants a file name: it gets a temporary one in the same folder, with
/// the same extension.
[[nodiscard]] Status write_file_atomically(
    const std::filesystem::path& path,
    const std::function<Status(const std::filesystem::path& temporary)>& write);

/// Replaces the folder `target` as a whole by one that `fill` has filled.
[[nodiscard]] Status replace_folder_atomically(
    const std::filesystem::path& target,
    const std::function<Status(const std::filesystem::path& fresh)>& fill);

/// Makes new and renamed entries of the folder reach the disk.
[[nodiscard]] Status sync_folder(const std::filesystem::path& folder);

/// Is this the name of a temporary file or folder of the functions above?
[[nodiscard]] bool is_temporary_name(const std::string& name);

/// Removes the temporary files and folders of the functions above that programs have left directly
/// in `folder` because they were killed. Call it before this program writes there; those of other
/// programs that still run stay.
void remove_dead_leftovers(const std::filesystem::path& folder);

/// The whole file as bytes; a message with path and reason if it cannot be read.
[[nodiscard]] Result<std::string> read_whole_file(const std::filesystem::path& path);

}  // namespace gripscan
