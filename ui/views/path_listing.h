// What could be meant by a path that is being typed: folders and cloud files, for completion.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gripscan::ui {

enum class PathKind { kFolder, kSession, kCloud };

struct PathEntry {
    std::filesystem::path path;
    std::string name;
    PathKind kind = PathKind::kFolder;
};

struct PathListing {
    std::filesystem::path folder;    ///< whose entries these are
    std::vector<PathEntry> entries;  ///< sessions first, then folders, then clouds, each by name
    std::string problem;             ///< in words; empty: it could be read
    bool cut = false;                ///< there are more
};

/// What lies in the folder that `typed` names, or of its parent's entries those that begin with its
/// last part. "~" is the home folder. Never more than `most` entries.
[[nodiscard]] PathListing list_paths(const std::string& typed, std::size_t most = 200);

/// The path as it is meant: "~" and "~/…" replaced.
[[nodiscard]] std::filesystem::path expanded(const std::string& typed);

/// Why it cannot be opened, in words; empty: it can be tried.
[[nodiscard]] std::string open_problem(const std::string& typed);

}  // namespace gripscan::ui
