#include "ui/views/path_listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <system_error>

namespace gripscan::ui {
namespace {
namespace fs = std::filesystem;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_cloud_file(const fs::path& path) {
    constexpr std::array<std::string_view, 3> kClouds{".pcd", ".ply", ".xyz"};
    const std::string extension = lower(path.extension().string());
    return std::find(kClouds.begin(), kClouds.end(), extension) != kClouds.end();
}

bool is_session(const fs::path& folder) {
    std::error_code code;
    return fs::exists(folder / "session.yaml", code);
}

/// What an entry of the folder is; nothing where it is of no use here.
std::optional<PathEntry> entry_of(const fs::directory_entry& found) {
    std::error_code code;
    PathEntry entry{found.path(), found.path().filename().string()};
    if (found.is_directory(code)) {
        entry.kind = is_session(found.path()) ? PathKind::kSession : PathKind::kFolder;
        return entry;
    }
    if (!is_cloud_file(found.path())) return std::nullopt;
    entry.kind = PathKind::kCloud;
    return entry;
}

int rank(PathKind kind) {
    return kind == PathKind::kSession ? 0 : kind == PathKind::kFolder ? 1 : 2;
}

}  // namespace

fs::path expanded(const std::string& typed) {
    const char* home = std::getenv("HOME");
    if (home == nullptr) return typed;
    if (typed == "~") return home;
    if (typed.starts_with("~/")) return fs::path(home) / typed.substr(2);
    return typed;
}

PathListing list_paths(const std::string& typed, std::size_t most) {
    PathListing listing;
    const fs::path whole = expanded(typed);
    std::error_code code;
    const bool is_folder = typed.ends_with('/') || typed == "~" || typed.empty();
    listing.folder = is_folder ? whole : whole.parent_path();
    if (listing.folder.empty()) listing.folder = ".";
    const std::string begin = is_folder ? std::string() : lower(whole.filename().string());
    fs::directory_iterator it(listing.folder, code);
    if (code) {
        listing.problem = fmt::format("{}: {}", listing.folder.string(), code.message());
        return listing;
    }
    for (; it != fs::directory_iterator(); it.increment(code)) {
        const std::string name = lower(it->path().filename().string());
        const bool hidden = name.starts_with('.') && !begin.starts_with('.');
        if (hidden || !name.starts_with(begin)) continue;
        if (auto entry = entry_of(*it)) listing.entries.push_back(*std::move(entry));
    }
    std::sort(listing.entries.begin(), listing.entries.end(),
              [](const PathEntry& a, const PathEntry& b) {
                  return std::pair(rank(a.kind), a.name) < std::pair(rank(b.kind), b.name);
              });
    listing.cut = listing.entries.size() > most;
    if (listing.cut) listing.entries.resize(most);
    return listing;
}

std::string open_problem(const std::string& typed) {
    if (typed.find_first_not_of(' ') == std::string::npos) return "Type or choose a path.";
    const fs::path whole = expanded(typed);
    std::error_code code;
    if (!fs::exists(whole, code)) return "There is nothing at this path.";
    if (fs::is_directory(whole, code)) {
        return is_session(whole) ? "" : "No session: the folder holds no session.yaml.";
    }
    return is_cloud_file(whole) ? "" : "Only PCD, PLY and XYZ files can be opened.";
}

}  // namespace gripscan::ui
