#include "ui/resources/resource_file.h"

#include <cstdlib>

#include "core/base/atomic_file.h"

namespace gripscan::ui {

namespace fs = std::filesystem;

std::vector<fs::path> resource_folders() {
    std::vector<fs::path> folders;
    if (const char* set = std::getenv("GRIPSCAN_RESOURCES"); set != nullptr && *set != '\0') {
        folders.emplace_back(set);
    }
    std::error_code unreadable;
    const fs::path program = fs::read_symlink("/proc/self/exe", unreadable);
    if (!unreadable) {
        folders.push_back(program.parent_path().parent_path() / "share" / "gripscan");
    }
    folders.emplace_back(GRIPSCAN_RESOURCES);
    return folders;
}

Result<fs::path> find_resource(std::string_view relative_path) {
    std::string looked_at;
    for (const fs::path& folder : resource_folders()) {
        const fs::path path = folder / relative_path;
        std::error_code ignored;
        if (fs::is_regular_file(path, ignored)) return path;
        looked_at += looked_at.empty() ? "" : ", ";
        looked_at += path.string();
    }
    return input_error(
        "{} of the window is missing (looked for {}); set GRIPSCAN_RESOURCES to the folder that "
        "holds shaders/ and assets/",
        relative_path, looked_at);
}

Result<std::string> read_resource(std::string_view relative_path) {
    const auto path = find_resource(relative_path);
    if (!path) return forward_error(path.error());
    return read_whole_file(*path);
}

}  // namespace gripscan::ui
