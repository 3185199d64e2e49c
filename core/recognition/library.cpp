#include "core/recognition/library.h"

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/base/checksum.h"
#include "core/cloud/cloud_file.h"

namespace gripscan {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kSidecar = ".template.json";

fs::path sidecar_of(const Library& library, const std::string& name) {
    return library.folder / fmt::format("{}{}", name, kSidecar);
}

bool is_plain_name(const std::string& name) {
    constexpr std::string_view kAllowed =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
    return !name.empty() && name.size() <= 64 && name.front() != '.' &&
           name.find_first_not_of(kAllowed) == std::string::npos;
}

void sort_by_name(std::vector<LibraryEntry>& entries) {
    std::sort(entries.begin(), entries.end(),
              [](const LibraryEntry& a, const LibraryEntry& b) { return a.name < b.name; });
}

Status remove_file(const fs::path& path) {
    std::error_code code;
    fs::remove(path, code);
    if (code) return input_error("{} cannot be removed: {}", path.string(), code.message());
    return {};
}

}  // namespace

const LibraryEntry* Library::find(const std::string& name) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const LibraryEntry& e) { return e.name == name; });
    return found == entries.end() ? nullptr : &*found;
}

Result<Library> open_or_begin_library(const fs::path& folder) {
    std::error_code code;
    if (!fs::exists(folder, code)) return Library{folder, {}};
    return open_library(folder);
}

Result<Library> open_library(const fs::path& folder) {
    std::error_code code;
    if (!fs::is_directory(folder, code)) {
        return input_error("{} is no folder; `gripscan library add` makes a library",
                           folder.string());
    }
    Library library{folder, {}};
    fs::directory_iterator files(folder, code);
    if (code) return input_error("{} cannot be read: {}", folder.string(), code.message());
    for (const auto& file : files) {
        const std::string name = file.path().filename().string();
        if (!name.ends_with(kSidecar) || is_temporary_name(name)) continue;
        const auto text = read_whole_file(file.path());
        if (!text) return forward_error(text.error());
        auto entry = parse_sidecar(file.path(), *text);
        if (!entry) return forward_error(entry.error());
        if (fmt::format("{}{}", entry->name, kSidecar) != name) {
            return input_error("{} calls its template '{}'; a sidecar is named after its template",
                               file.path().string(), entry->name);
        }
        library.entries.push_back(std::move(*entry));
    }
    sort_by_name(library.entries);
    return library;
}

Result<Cloud> load_entry(const Library& library, const LibraryEntry& entry) {
    const fs::path path = library.folder / entry.file;
    const auto bytes = read_whole_file(path);
    if (!bytes) return forward_error(bytes.error());
    if (checksum_text(*bytes) != entry.check) {
        return input_error(
            "{} is not what its sidecar describes: its check sum differs; add the "
            "template again",
            path.string());
    }
    return load_cloud(path);
}

Status store_entry(Library& library, LibraryEntry entry, const std::string& pcd) {
    if (!is_plain_name(entry.name)) {
        return input_error(
            "'{}' cannot be a template's name: letters, digits, '.', '_' and '-' "
            "only, at most 64",
            entry.name);
    }
    std::error_code code;
    fs::create_directories(library.folder, code);
    if (code) {
        return input_error("{} cannot be made: {}", library.folder.string(), code.message());
    }
    entry.check = checksum_text(pcd);
    entry.file = fmt::format("{}.{}.pcd", entry.name, entry.check.substr(entry.check.size() - 8));
    if (Status s = write_file_atomically(library.folder / entry.file, pcd); !s) return s;
    if (Status s = write_file_atomically(sidecar_of(library, entry.name), sidecar_text(entry));
        !s) {
        return s;
    }
    const LibraryEntry* old = library.find(entry.name);
    const std::string old_file = old == nullptr ? entry.file : old->file;
    std::erase_if(library.entries, [&](const LibraryEntry& e) { return e.name == entry.name; });
    const std::string new_file = entry.file;
    library.entries.push_back(std::move(entry));
    sort_by_name(library.entries);
    if (old_file != new_file) return remove_file(library.folder / old_file);
    return {};
}

Status remove_entry(Library& library, const std::string& name) {
    const LibraryEntry* entry = library.find(name);
    if (entry == nullptr) {
        return input_error("the library {} has no template '{}'", library.folder.string(), name);
    }
    const fs::path points = library.folder / entry->file;
    if (Status s = remove_file(sidecar_of(library, name)); !s) return s;
    if (Status s = remove_file(points); !s) return s;
    std::erase_if(library.entries, [&](const LibraryEntry& e) { return e.name == name; });
    return sync_folder(library.folder);
}

std::string_view word(Lineage lineage) {
    switch (lineage) {
        case Lineage::kNone:
            return "none";
        case Lineage::kCurrent:
            return "current";
        case Lineage::kStale:
            return "stale";
        case Lineage::kMissing:
            return "missing";
    }
    return "none";
}

Lineage lineage_of(const Library& library, const LibraryEntry& entry) {
    if (!entry.held) return Lineage::kNone;
    const bool there =
        std::any_of(library.entries.begin(), library.entries.end(),
                    [&](const LibraryEntry& e) { return e.check == entry.held->check; });
    if (there) return Lineage::kCurrent;
    const bool named = !entry.held->gripper.empty() && library.find(entry.held->gripper) != nullptr;
    return named ? Lineage::kStale : Lineage::kMissing;
}

}  // namespace gripscan
